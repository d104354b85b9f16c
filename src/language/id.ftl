### Semua teks program dalam bahasa Indonesia. Kunci menamai pesannya di setiap katalog; argumennya sama di semua katalog.

## focus

focus-frame = seluruh gambar
focus-polygon = poligon { $number }
focus-line = garis scan { $number }
focus-pixel = piksel ({ $x }, { $y })
focus-iterations = iterasi { $first }–{ $last }
focus-patch = patch { $number }
