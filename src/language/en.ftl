### All text of the program in English. A key names its message in every catalogue; arguments are the same in all of them.

## focus

focus-frame = the whole picture
focus-polygon = polygon { $number }
focus-line = scan line { $number }
focus-pixel = pixel ({ $x }, { $y })
focus-iterations = iterations { $first }–{ $last }
focus-patch = patch { $number }
