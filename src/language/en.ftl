### All text of the program in English. A key names its message in every catalogue; arguments are the same in all of them.

## focus

focus-frame = the whole picture
focus-polygon = polygon { $number }
focus-line = scan line { $number }
focus-pixel = pixel ({ $x }, { $y })
focus-iterations = iterations { $first }–{ $last }
focus-patch = patch { $number }

## common

common-patches = patches
common-error = error
common-of = of
common-matrix-of-form-factors = Matrix of form factors
common-light = light
common-eye = eye
common-rays = rays
common-relative-residual = relative residual
common-in-hand = In hand:
common-total-internal-reflection = total internal reflection
common-level = level

## app

app-present = Present
app-share = Share step
app-shared = Copied: the command that opens this lesson at this step.
app-theme = Theme
app-theme-light = light
app-theme-dark = dark
app-theme-projector = projector
app-keys = keys
app-keys-title = Keys
app-close = Close
app-menu = More
app-questions = Ask me questions
app-studies = Error against run time
app-study = Study
app-quick = few and small settings
app-measure = Measure
app-call-off = Call off
app-back-to-the-run = Back to the lesson
app-measuring = measuring
app-called-off = Called off; what had come stays.
app-no-findings = No result:
app-nothing-measured = Choose a study and measure it. It runs in the background, on one thread.
app-debug-build = This is a debug build: its times say nothing about the algorithms.
app-study-plot = plot of the study
app-time-of-a-run = time of a run (median)
app-rms-error-of = rms error of
app-on-the-front = On the Pareto front: no other setting is as quick and as exact.
app-time-is = time
app-quartiles = quartiles
app-memory-is = memory
app-no-law = no clean law
app-click-opens-it = A click opens its picture and its run.
app-measured-again-by = It draws no picture. Measured again, with a row of its own in the table, by
app-reference = Reference
app-pareto = Ringed, on the grey line: the Pareto front. Bars: quartiles.
app-text-size = Text size
app-one-back = one event back
app-one-on = one event on
app-step = step
app-steps-a-second = steps/s
app-loop = loop
app-loop-off = loop off
app-loop-from-here = from this step
app-loop-to-here = to this step
app-run-to = run to
app-next-of-this-kind = next of this kind
app-search = search
app-search-hint = EdgeInterpolated y=15
app-breakpoint = breakpoint
app-truncated = Only the beginning of this run fits in memory; the picture is whole all the same.
app-making-the-picture = whole picture:
app-unsaid = With these values, some of what this lesson explains does not happen.
app-put-back = Start again with the lesson's own values
app-slide = As on the slide
app-last-said = Said before, at step
app-other-focus = You look at another part than the lesson does.
app-before-you-go-on = Before you go on
app-check = Check
app-skip = skip
app-your-answer = Your answer
app-click-a-pixel = Click the pixel in the image.
app-right = Right.
app-wrong = Not quite.
app-skipped = Skipped.
app-the-answer-is = The answer is
app-show-the-step = show the step
app-image = Image
app-scan-line = Scan line
app-active-edges = Active edges
app-vertex = Vertex
app-left-out = Left out: not needed here
app-left-out-about = The scene needs none of this, so it is not done. Tick a line to have it done all the same: nothing changes but the steps and the time.
app-nothing-left-out = Nothing: this way to draw the scene needs all that it does.
app-is-needed = That is needed here, or not part of this method.
app-times-measured = measuring …
app-times-none = too slow to be timed here; `lightwalk needs` measures it
app-time-without = left out:
app-time-with = done all the same:
app-time-tie = no difference beyond noise
app-share-as-left-out-only = The steps differ from the lesson's while something is done that is not needed.
app-unsaid-anyway = With that done all the same, the lesson does not find its steps.
app-leave-out-again = Start again with it left out
app-ray-tree = Ray tree
app-vectors = Vectors at the point
app-radiosity = Radiosity, patch by patch
app-form-factor = Form factor
app-convergence = Convergence
app-race = Solvers side by side
app-comparison = Methods side by side
app-difference = Differences
app-profile = Along the scan line
app-smooth = smooth
app-smooth-room = interpolate the light between the corners of patches
app-illumination = Terms, and the slide's factor
app-rays = Rays in the scene
app-tree-fit = fit
app-whole-tree = show the whole tree
app-larger-tree = larger tree
app-smaller-tree = smaller tree
app-tree-as-it-is = The tree is already shown that way.
app-inspector = Inspector
app-code = Code
app-formula = Formula
app-time-line = Time line
app-click-a-row = click a row to light it up
app-drag-the-light = drag to move the light
app-drag-the-eye = drag to move the eye
app-parameters = Parameters
app-put-back-all = lesson's values
app-as-a-number = as a number
app-distance = distance
app-from-the-target = from what the camera looks at
app-divisions = divisions
app-line = line
app-polygon = polygon
app-pixel = pixel
app-frame = whole picture
app-focus-on = Look at
app-the-lessons-part = the lesson's part
app-at-the-start = This is the first step.
app-at-the-end = This is the last step.
app-no-scope-ahead = No further scope opens behind this step.
app-no-scope-before = No scope opens before this step.
app-nothing-around = This step lies in no scope that could be left.
app-nothing-narrated-ahead = Nothing more is explained behind this step.
app-nothing-narrated-before = Nothing is explained before this step.
app-answer-first = Answer the question first, or skip it.
app-no-question = No question waits at this step.
app-not-a-number = That is no number; write for example 0.52.
app-not-found = No step matches.
app-fastest = This is the fastest.
app-slowest = This is the slowest.
app-no-loop = No loop is set; [ and ] set one.
app-nothing-under-pointer = Point at a pixel, a scan line or a polygon first.
app-nothing-drawn-there = No polygon is seen at that pixel.
app-outside = That lies outside the picture.
app-largest = The text is as large as it gets.
app-smallest = The text is as small as it gets.
app-no-such-lesson = There is no such lesson.
app-stays = The lesson keeps this as it is.
app-still-measuring = A study is being measured; call it off first.
app-nothing-is-measured = Nothing is being measured.
app-no-such-study = There is no such study.
app-no-such-point = There is no such point.
app-share-no-study = A point of a study can only be opened from the study.
app-too-far = That is too far away.
app-no-view = From there, what is up in the picture would not be known.
app-out-of-range = That value cannot be had.
app-share-unchanged-only = A parameter was changed: r puts it back, and then this step can be shared.
app-share-lesson-only = Only steps of the lesson itself can be shared; r leads back to it.

## active-edges

active-edges-no-edges = No edge table is at hand at this step: each polygon builds its own. There each edge gets a row, and the active ones stand out.
active-edges-no-table = A wireframe needs no edge table: its edges are drawn one by one. Open a flat or Gouraud lesson to see one.
active-edges-edge = edge
active-edges-from = y from
active-edges-to = y to
active-edges-a-line = line
active-edges-waits = waits
active-edges-done = done
active-edges-more = more

## app-skipped

skipped-reflected-rays = Reflected rays
skipped-reflected-rays-because = Nothing reflects.
skipped-transmitted-rays = Transmitted rays
skipped-transmitted-rays-because = Nothing is transparent.
skipped-texture-coordinates = Texture coordinates
skipped-texture-coordinates-because = Nothing has a texture.
skipped-highlights = Highlights
skipped-highlights-because = Nothing is shiny: no cosine is raised to a power.
skipped-light-balls = Light balls
skipped-light-balls-because = No light has a radius that a ray could meet.
skipped-path-attenuation = Attenuation on the way
skipped-path-attenuation-because = The scene asks for none.
skipped-shadow-rays = Shadow rays
skipped-shadow-rays-because = Nothing can stand between these objects and the light.
skipped-dark-channels = Dark channels
skipped-dark-channels-because = Nothing emits in them: B = 0.
skipped-equal-channels = Equal channels
skipped-equal-channels-because = Emission and reflectance are those of a channel before: solved once.
skipped-black-rows = Equations of black patches
skipped-black-rows-because = They reflect nothing: B = E.
skipped-facing-away = Integrals of pairs that face away
skipped-facing-away-because = In one plane, or one behind the other: F = 0.
skipped-sight-tests = Rays between patches
skipped-sight-tests-because = Nothing can stand between the two: all light passes.
app-skipped-plane = an infinite plane has no polygons
app-skipped-objects = objects
app-skipped-pairs = pairs of patches

## comparison

comparison-illuminated = lit
comparison-interpolated = interpolated
comparison-roots = roots
comparison-series = from a series
comparison-a-pixel = a pixel

## convergence

convergence-bound = bound on the error of B
convergence-iteration = iteration k
convergence-none-yet = No iteration has come to its end yet.

## difference

difference-against = luminance minus that of
difference-rms = rms
difference-largest = max
difference-here = here

## form-factor

form-factor-no-pair = This run solves for the light of all patches. Look at one form factor to see how it is found.
form-factor-exact = reference
form-factor-hits = met j
form-factor-free = unblocked

## illumination

illumination-nothing = While a point is being lit, this panel shows the terms of its intensity. At this step none is.
illumination-no-light = This run lights no points. Open a lesson on illumination.
illumination-standard = standard
illumination-slide = slide
illumination-ratio = slide : standard
illumination-factor = factor
illumination-distance = distance d

## formula

formula-no-formula = This step has no formula. Go on to the next.

## image

image-only = focus:
image-drawn = pixels drawn so far:

## keys

keys-next-event = next event
keys-event-before = event before
keys-ten-events-on = ten events on
keys-ten-events-back = ten events back
keys-next-scope = next scope
keys-previous-scope = previous scope
keys-into-the-scope = into the scope
keys-out-of-the-scope = out of the scope
keys-over-the-scope = over the scope
keys-first-step = first step
keys-last-step = last step
keys-next-explained-step = next explained step
keys-explained-step-before = explained step before
keys-play-or-pause = play or pause
keys-play-backwards = play backwards
keys-slower = slower
keys-faster = faster
keys-loop-from-this-step = loop from this step
keys-loop-to-this-step = loop to this step
keys-breakpoint-here = breakpoint here
keys-look-at-what-the-pointer = look at what the pointer is over
keys-start-the-lesson-over = start the lesson over
keys-inspector = inspector
keys-questions-on-or-off = questions on or off
keys-english-or-indonesian = English or Indonesian
keys-next-theme = next theme
keys-presentation = presentation
keys-end-the-presentation = end the presentation
keys-larger-text = larger text
keys-smaller-text = smaller text
keys-normal-text = normal text
keys-copy-the-command-that-opens = copy the command that opens this step
keys-skip-the-question = skip the question
keys-error-against-run-time = error against run time
keys-all-keys = all keys

## matrix

matrix-no-matrix = This run finds one form factor, not all of them. Open a lesson on a radiosity solver.
matrix-no-room = This scene has no patches: radiosity needs surfaces of finite size.
matrix-gathers = gathers row
matrix-shoots = shoots column
matrix-sum = sum of the row

## panels

panels-no-steps = Nothing is recorded here: no polygon lies in the focus. Click the image to look at another place.
panels-no-polygons = This method follows rays and converts no polygons. Look at the ray tree.
panels-no-rays = This method converts polygons and follows no rays. Open a lesson on ray casting or ray tracing.
panels-no-patches = This run exchanges no light between patches. Open a lesson on radiosity.
panels-not-compared = The pictures to be compared are being made, or this lesson compares none.
panels-step = Step
panels-yes = yes
panels-no = no

## profile

profile-intensity = intensity
profile-slope = its slope, a pixel (jumps of the value are cut off)
profile-seen = as it looks (lateral inhibition)
profile-line = scan line
profile-largest-jump = largest jump of slope

## race

race-iterations = iterations (n shots count as one)
race-time = seconds
race-error = relative error of B
race-running = The solvers are still running.
race-no-solution = This room has no solution, so nobody can win.
race-not-begun = The solvers wait at the start. Step to the end of an iteration.
race-gave-up = gave up
race-on-the-way = under way

## radiosity

radiosity-radiosity = radiosity B
radiosity-with-unshot = radiosity B + unshot
radiosity-unshot = unshot radiosity
radiosity-emission = emission E
radiosity-reflectance = reflectance ρ
radiosity-patches = Patches of the room:
radiosity-seen = seen from their front, through the backs of those that turn away:
radiosity-no-room = This scene cannot be divided into patches: a surface has no end, no area, or there are too many.
radiosity-red = red
radiosity-green = green
radiosity-blue = blue

## ray-tree

ray-tree-no-ray = Once a ray is sent through a pixel, this panel draws the tree of all rays that make its colour. At this step there is none yet: step on.
ray-tree-no-rays = This method converts polygons and follows no rays. Open a lesson on ray casting or ray tracing to see a pixel's ray tree.
ray-tree-inside = inside
ray-tree-background = background
ray-tree-leaves = leaves the scene
ray-tree-leaves-short = leaves
ray-tree-light-met = meets a light
ray-tree-searching = searching …
ray-tree-not-traced = not traced yet
ray-tree-asked = asked for
ray-tree-no-transmitted = no transmitted ray
ray-tree-depth-reached = depth reached
ray-tree-no-coefficient = no coefficient
ray-tree-ray = ray
ray-tree-hidden = not shown
ray-tree-shadow-rays = Shadow rays at
ray-tree-lights = Lights at
ray-tree-coming-back = Coming back up
ray-tree-blocked = blocked
ray-tree-blocked-by = blocked by
ray-tree-clear = clear
ray-tree-so-far = so far
ray-tree-nearest = nearest
ray-tree-tested = tested
ray-tree-missed = missed

## rays

rays-side = from the side
rays-above = from above
rays-rays = Rays of the pixel so far:
rays-no-pixel = No ray is followed yet. Go on to the first pixel.
rays-plane = picture plane

## scan-line

scan-line-no-polygon = No polygon is in hand at this step. Go on (→) to the next polygon: its edges, the scan line and the span stand here.
scan-line-no-weights = The weights of an interpolation stand here.
scan-line-no-line = No edge is being drawn at this step. Go on (→) to the next edge: its line and the pixels that it takes stand here.
scan-line-weights = weights
scan-line-ramp = ramp
scan-line-direct = direct
scan-line-incremental = incremental
scan-line-difference = difference

## vectors

vectors-not-yet = This ray has met no surface yet. Go on until the nearest object is found.
vectors-no-point = While a point is being lit, this panel shows its vectors. At this step none is.
vectors-no-surface = This ray meets no surface: it takes the colour of the background, or of a light. Click an object in the image.
vectors-angles = angle with N
vectors-blocked = blocked by
vectors-arrives = arrives
vectors-away = behind the surface
vectors-leans = out of the plane
vectors-critical = critical
vectors-no-t = no T
vectors-air = air

## vertex

vertex-nothing = While a point is being lit, this panel shows its normal, the vectors to light and eye, and the terms of its intensity. At this step none is.
vertex-wireframe = A wireframe lights nothing: it draws edges only. Open a flat or Gouraud lesson to see how a point is lit.
