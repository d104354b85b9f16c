### All text of the program in English. A key names its message in every catalogue; arguments are the same in all of them.

## focus

focus-frame = the whole picture
focus-polygon = polygon { $number }
focus-line = scan line { $number }
focus-pixel = pixel ({ $x }, { $y })
focus-iterations = iterations { $first }–{ $last }
focus-patch = patch { $number }

## common

common-error = error
common-named = { $name }: { $what }
common-matrix-of-form-factors = Matrix of form factors { $n } × { $n }.
common-light = light
common-eye = eye
common-blocked = blocked
common-blocked-by = blocked by { $object }, t { $t }
common-relative-residual = relative residual
common-total-internal-reflection = total internal reflection
common-level = level { $level }

## app

app-present = Present
app-share = Share step
app-shared = Copied: the command that opens this lesson at this step. { $command }
app-theme = Theme
app-theme-light = light
app-theme-dark = dark
app-theme-projector = projector
app-keys = keys
app-keys-title = Keys
app-close = Close
app-menu = More
app-lessons = Lessons
app-chapter-shading = Shading
app-chapter-ray-tracing = Ray tracing
app-chapter-radiosity = Radiosity
app-chapter-study = Study
app-next-lesson = next lesson
app-previous-lesson = previous lesson
app-no-next-lesson = This is the last lesson.
app-no-previous-lesson = This is the first lesson.
app-not-in-the-list = This lesson is not in the list of lessons.
app-search-lessons = search in all lessons
app-no-lesson-found = No lesson has all of these words.
app-begin = Begin: { $title }
app-continue = Continue: { $title }
app-explanations = { $count } explanations
app-explanation-of = explanation { $number } of { $count }
app-start-again = Start again
app-outline = outline
app-outline-at = outline: { $place }
app-finish = finish the lesson
app-finished = Finished: { $title }
app-learned = What you have learned
app-questions-right = { $right } of { $count } questions right
app-look-again = Look at these again
app-next-lesson-is = Next: { $title }
app-not-answered = not answered
app-entry = Explanation { $number }: { $title }
app-entry-asks = Explanation { $number }: { $title } (question: { $stands })
app-score = { $right } of { $count } right
app-forget = Forget my progress …
app-forget-what = Forget your position, your answers and your score in all lessons? This cannot be undone. Language, theme and text size stay.
app-forget-it = Forget my progress
app-keep-it = Keep it
app-kept-set-aside = The file of your progress could not be read. It is now { $path }, and your progress starts anew.
app-not-kept = Your progress is not saved: { $why }
app-questions = Ask me questions
app-studies = Error against run time
app-study = Study
app-quick = few and small settings
app-measure = Measure
app-call-off = Cancel
app-back-to-the-run = Back to the lesson
app-measuring = measuring { $percent } %
app-called-off = Cancelled. What was measured until then stays.
app-no-findings = No result: { $why }
app-nothing-measured = Choose a study and measure it. It runs in the background, on one thread.
app-debug-build = This is a debug build: its times say nothing about the algorithms.
app-study-plot = plot of the study
app-on-the-front = On the Pareto front: no other setting is as quick and as exact.
app-point-time = time: { $median } (quartiles { $lower } – { $upper }, { $runs }×)
app-point-errors = error: rms { $rms }, max { $largest }, rel { $relative }
app-memory-is = memory { $bytes }
app-no-law = no clean law
app-law-of-error = error { $law }
app-law-of-time = time { $law }
app-click-opens-it = A click opens its picture and its run.
app-measured-again-by = It draws no picture. Measured again, with a row of its own in the table, by { $command }
app-reference = Reference
app-pareto = Ringed, on the grey line: the Pareto front. Bars: quartiles.
app-text-size = Text size
app-text-size-to = Text size { $size }
app-one-back = one event back
app-one-on = one event on
app-step-of = step { $step } of { $last }
app-steps-a-second = { $speed } steps/s
app-loop = loop { $from }–{ $to }
app-loop-off = loop off
app-loop-from-here = from this step
app-loop-to-here = to this step
app-run-to = run to
app-next-of-this-kind = next of this kind: { $kind }
app-search = search
app-search-hint = EdgeInterpolated y=15
app-breakpoint = breakpoint
app-truncated = Only the beginning of this run fits in memory; the picture is whole all the same.
app-making-the-picture = whole picture: { $percent } %
app-unsaid = With these values, some of what this lesson explains does not happen.
app-put-back = Start again with the lesson's own values
app-slide = As on the slide
app-other-focus = You look at another part than the lesson does.
app-before-you-go-on = Before you go on
app-check = Check
app-skip = skip
app-your-answer = Your answer
app-click-a-pixel = Click the pixel in the image.
app-move-up = Move up: { $item }
app-move-down = Move down: { $item }
app-click-an-object = Click the object in the image, or choose it here:
app-click-a-patch = Click the patch in the room, or choose it here:
app-turn-the-arrow = Drag the arrow in the vectors panel, or turn it with the arrow keys; Enter answers.
app-arrow-angle = Angle of { $name }
app-undecided = With the values that you have set, this question has no single answer.
app-lessons-values = Put the lesson's values back
app-answer-now = With the values set now, the answer is { $answer }.
app-once-more = { $hint } Try once more.
app-you-answered = Your answer was { $answer }.
app-matrix = Matrix of form factors
app-right = Right.
app-wrong = Not quite.
app-skipped = Skipped.
app-the-answer-is = The answer is
app-show-the-step = show the step { $step } →
app-image = Image
app-scan-line = Scan line
app-active-edges = Active edges
app-vertex = Vertex
app-left-out = Left out: not needed here
app-left-out-about = The scene needs none of this, so it is not done. Tick a line to have it done all the same: nothing changes but the steps and the time.
app-nothing-left-out = Nothing: this way to draw the scene needs all that it does.
app-is-needed = That is needed here, or not part of this method.
app-times-measured = measuring …
app-times-none = too slow to be timed here; “lightwalk needs” measures it
app-times = left out: { $without }   done all the same: { $with }
app-times-tie = left out: { $without }   done all the same: { $with } (no difference beyond noise)
app-share-as-left-out-only = The steps differ from the lesson's while something is done that is not needed.
app-unsaid-anyway = With that done all the same, the lesson does not find its steps.
app-leave-out-again = Start again with it left out
app-ray-tree = Ray tree
app-vectors = Vectors
app-radiosity = Radiosity
app-form-factor = Form factor
app-convergence = Convergence
app-race = Solver race
app-comparison = Comparison
app-difference = Differences
app-profile = Along the scan line
app-smooth = smooth
app-smooth-room = interpolate the light between the corners of patches
app-illumination = Illumination terms
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
app-answer-with-a-key = Press a for the answer.
app-unfill = back to all panels
app-enlarge = show { $panel } large
app-no-such-panel = This lesson has no panel of that number.
app-is-key-panel = This panel is the large one already.
app-no-parameters = This lesson has nothing to change.
app-parameters = Parameters
app-put-back-all = lesson's values
app-as-a-number = { $name } (as a number)
app-distance = { $thing }, distance
app-from-the-target = from what the camera looks at
app-divisions = divisions { $object }
app-line = line { $y }
app-polygon = polygon
app-frame = whole picture
app-focus-on = Look at
app-the-lessons-part = the lesson's part
app-at-the-start = This is the first step.
app-at-the-end = This is the last step.
app-no-scope-ahead = No scope opens after this step.
app-no-scope-before = No scope opens before this step.
app-nothing-around = This step lies in no scope that could be left.
app-nothing-narrated-ahead = That was the last explanation.
app-nothing-narrated-before = Nothing is explained before this step.
app-answer-first = Answer the question first, or skip it.
app-no-question = No question waits at this step.
app-not-a-number = That is no number; write for example 0.52.
app-results = Found
app-first-results = These are the first { $count }.
app-results-to-question = The list ends at the question of step { $step }; answer it, then search again.
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
app-still-measuring = A study is being measured; cancel it first.
app-nothing-is-measured = Nothing is being measured.
app-no-such-study = There is no such study.
app-no-such-point = There is no such point.
app-share-no-study = A point of a study can only be opened from the study.
app-too-far = That is too far away.
app-no-view = From there, what is up in the picture would not be known.
app-out-of-range = That value is out of range.
app-share-unchanged-only = A parameter was changed: r puts it back, and then this step can be shared.
app-share-lesson-only = Only steps of the lesson itself can be shared; r leads back to it.
app-said-of-a-point = A point of a study: { $setting } came to an rms error of { $error } in { $time } on one thread. Here is the run behind it; the list of lessons leads back, and the menu to the study.
app-said-of-a-picture = A point of a study: { $setting } came to a picture in { $time } on one thread. Here is the run behind it; the list of lessons leads back, and the menu to the study.

## active-edges

active-edges-no-edges = At this step there is no edge table: each polygon builds its own. Within a polygon, every edge has a row here, and the active ones stand out.
active-edges-no-table = A wireframe needs no edge table: its edges are drawn one by one. Open a flat or Gouraud lesson to see one.
active-edges-edge = edge
active-edges-from = y from
active-edges-to = y to
active-edges-a-line = Δ{ $value }/line
active-edges-waits = waits
active-edges-done = done

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
skipped-path-attenuation-because = The scene has none.
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
app-skipped-plane = { $object }: an infinite plane has no polygons
app-skipped-objects = { $some } of { $all } objects
app-skipped-patches = { $some } of { $all } patches
app-skipped-pairs = { $some } of { $all } pairs of patches

## comparison

comparison-illuminated = { $count } lit
comparison-interpolated = { $count } interpolated
comparison-roots = { $count } roots
comparison-series = { $count } from a series
comparison-rays = { $count } rays
comparison-a-pixel = { $time } ns a pixel

## convergence

convergence-bound = bound on the error of B
convergence-iteration = iteration k
convergence-none-yet = No iteration has come to its end yet.
convergence-so-far = { $channel }: iteration k { $k }, relative residual { $residual }.
convergence-so-far-bounded = { $channel }: iteration k { $k }, relative residual { $residual }, bound on the error of B { $bound }.

## difference

difference-against = luminance minus that of { $method }
difference-rms = rms { $value }
difference-largest = max { $value }
difference-here = here: { $value }

## form-factor

form-factor-no-pair = This run solves for the light of all patches. Look at one form factor to see how it is found.
form-factor-exact = reference
form-factor-hits = met j: { $part } of { $all }
form-factor-free = unblocked: { $part } of { $all }

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

## hints after a first wrong answer

hint-too-small = That is too small.
hint-too-large = That is too large.
hint-another = Not that one.
hint-in-place = Of the { $all }, in the right place: { $count }.
pick-nothing = nothing
hint-turn-clockwise = Turn it further clockwise.
hint-turn-counterclockwise = Turn it further counterclockwise.
arrow-clockwise = { $degrees }° clockwise from straight up
arrow-counterclockwise = { $degrees }° counterclockwise from straight up
hint-one-way = The pixel lies further { $way }.
hint-two-ways = The pixel lies further { $across } and further { $along }.
hint-way-left = to the left
hint-way-right = to the right
hint-way-up = up
hint-way-down = down

## image

image-only = focus: { $focus }
image-drawn = pixels drawn so far: { $count }.

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
keys-next-explained-step = next explanation
keys-explained-step-before = previous explanation
keys-play-or-pause = play or pause
keys-play-backwards = play backwards
keys-slower = slower
keys-faster = faster
keys-loop-from-this-step = loop from this step
keys-loop-to-this-step = loop to this step
keys-breakpoint-here = breakpoint here
keys-look-at-what-the-pointer = look at what the pointer is over
keys-start-the-lesson-over = start the lesson again
keys-show-the-answer = show the answer
keys-fill = the key panel fills the window
keys-key-panel = show panel 1 to 9 large
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
keys-all-lessons = all lessons

## matrix

matrix-no-matrix = This run finds one form factor, not all of them. Open a lesson on a radiosity solver.
matrix-no-room = This scene has no patches: radiosity needs surfaces of finite size.
matrix-gathers = { $patch } gathers row { $row }, sum of the row { $sum }
matrix-shoots = { $patch } shoots column { $column }

## panels

panels-no-steps = Nothing is recorded here: no polygon lies in the focus. Click the image to look at another place.
panels-no-polygons = This method follows rays and converts no polygons. Look at the ray tree.
panels-no-rays = This method converts polygons and follows no rays. Open a lesson on ray casting or ray tracing.
panels-no-patches = This run exchanges no light between patches. Open a lesson on radiosity.
panels-after-your-answer = after your answer
panels-not-compared = The pictures to be compared are being made, or this lesson compares none.
panels-step = Step { $step }, { $kind }
panels-no-step = Step –
panels-step-and-values = { $step }: { $values }.
panels-yes = yes
panels-no = no

## profile

profile-intensity = intensity
profile-slope = slope per pixel (jumps cut off)
profile-seen = as it looks (lateral inhibition)
profile-line = scan line y = { $y }
profile-largest-jump = { $method }: largest jump of slope { $jump }

## race

race-iterations = iterations (n shots = 1)
race-time = seconds
race-error = relative error of B
race-running = The solvers are still running.
race-no-solution = This room has no solution, so nobody can win.
race-not-begun = The solvers wait at the start. Step to the end of an iteration.
race-gave-up = gave up
race-gave-up-after = gave up ({ $effort })
race-on-the-way = under way
race-patches = { $count } patches

## solvers, where there is little room

racer-jacobi = Jacobi
racer-gauss-seidel = Gauss–Seidel
racer-over-relaxation = over-relaxation
racer-chebyshev = Chebyshev

## radiosity

radiosity-radiosity = radiosity B
radiosity-with-unshot = radiosity B + unshot
radiosity-unshot = unshot radiosity, { $channel }
radiosity-emission = emission E
radiosity-reflectance = reflectance ρ
radiosity-patches = Patches of the room: { $patches }, seen from their front, through the backs of those that turn away: { $seen }.
radiosity-current = Current patch: { $exchange }
radiosity-no-room = This scene cannot be divided into patches: a surface has no end, no area, or there are too many.

## ray-tree

ray-tree-no-ray = Once a ray is sent through a pixel, this panel draws the tree of all rays that make its colour. At this step there is none yet: step on.
ray-tree-no-rays = This method converts polygons and follows no rays. Open a lesson on ray casting or ray tracing to see a pixel's ray tree.
ray-tree-inside = { $object }, inside
ray-tree-background = background
ray-tree-leaves = leaves the scene
ray-tree-leaves-short = leaves
ray-tree-light-met = meets a light
ray-tree-searching = searching …
ray-tree-not-traced = not traced yet
ray-tree-asked = waiting
ray-tree-no-transmitted = no transmitted ray
ray-tree-depth-reached = depth reached
ray-tree-no-coefficient = no coefficient
ray-tree-rays = { $count ->
    [one] { $count } ray
   *[other] { $count } rays
 }
ray-tree-hidden = { $count } not shown
ray-tree-level = level { $level } of { $deepest }
ray-tree-shadow-rays = Shadow rays at { $thing }
ray-tree-lights = Lights at { $thing }
ray-tree-coming-back = Coming back up
ray-tree-blocked = { $light } blocked
ray-tree-blocked-by = { $light } blocked by { $object }
ray-tree-clear = { $light } clear
ray-tree-clear-at = clear, d { $distance }
ray-tree-so-far = so far { $light }
ray-tree-nearest = nearest: { $thing }, t { $t }
ray-tree-tested = tested: { $thing }, t { $t }
ray-tree-missed = tested: { $thing }, missed

## rays

rays-side = from the side
rays-above = from above
rays-rays = Rays of the pixel so far: { $count }. Current ray: { $kind }, level { $level }{ $goal }.
rays-no-pixel = No ray is followed yet. Go on to the first pixel.
rays-plane = picture plane

## scan-line

scan-line-no-polygon = At this step no polygon is drawn. Go on (→) to the next one: its edges, the scan line and the span appear here.
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
vectors-angles = { $surface } · angle with N
vectors-arrives = arrives
vectors-away = behind the surface
vectors-leans = { $angle } out of the plane
vectors-critical = critical
vectors-no-t = no T
vectors-air = air

## vertex

vertex-nothing = While a point is being lit, this panel shows its normal, the vectors to light and eye, and the terms of its intensity. At this step none is.
vertex-wireframe = A wireframe lights nothing: it draws edges only. Open a flat or Gouraud lesson to see how a point is lit.

## what a step does

event-frame = The frame begins: { $width } × { $height } pixels, lit by the ambient light A.
event-polygon = Polygon { $polygon } begins; it belongs to object { $object }.
event-polygon-done = Polygon { $polygon } is done.
event-frame-done = The frame is done.
event-face-normal-added = Face { $face } shares the vertex: its unit normal is added.
event-vertex-normal = The vertex normal: the mean direction of the face normals, of unit length.
event-file-normal = The normal that the mesh file gives this corner.
event-normal-vanished = The face normals cancel out: the first one stands for their mean.
event-illumination = The illumination model at the point P with the unit normal N.
event-viewer-along-ray = The way back along the ray stands for the direction to the eye.
event-viewer-turned = The eye sees the other side: N was turned toward it.
event-viewer = The unit vector from the point to the eye; N is on its side already.
event-ambient = The ambient term: light from all around.
event-light = Light { $light } at the distance d, weakened by the attenuation f_{"{"}att{"}"}.
event-light-infinitely-far = Light { $light } is infinitely far: nothing weakens it.
event-to-light = The unit vector to the light, and its cosine with the normal.
event-diffuse = The diffuse term: proportional to the cosine between normal and light.
event-mirrored = The light's direction mirrored at the normal, and its cosine with the direction of the eye (Phong).
event-halfway = Half-way between light and eye, and its cosine with the normal (Blinn).
event-specular-none = No highlight: the light is behind the surface, N·L ≤ 0.
event-specular = The specular term: the highlight, narrower the larger n is.
event-light-added-blocked = The light is blocked: it adds nothing.
event-light-added-matte = What light { $light } adds; no surface of this scene has a highlight.
event-light-added = What light { $light } adds to the intensity.
event-illuminated = The intensity of the point: the ambient term and what each light adds.
event-edge-table = The edge table of a polygon of { $corners } corners begins.
event-corner-placed = Corner { $corner } on the screen, in pixels; z is its depth.
event-edge-entered = Edge { $upper }–{ $lower } is entered: it cuts the scan lines from { $first } on, up to but not including { $end }.
event-edge-skipped = Edge { $from }–{ $to } passes the centre of no row: it is left out.
event-edge-table-built = The edge table is built; edges in it: { $edges }.
event-scan-line = Scan line { $y } begins: its pixel centres lie at y_4 = { $y_4 }.
event-edge = The scan line cuts edge { $upper }–{ $lower } at x_4.
event-edge-ends-normal = The normals at the two ends of edge { $upper }–{ $lower }.
event-edge-ends-intensity = The intensities at the two ends of edge { $upper }–{ $lower }.
event-edge-interpolated-normal = The normal where the scan line cuts edge { $upper }–{ $lower }: the nearer end weighs more.
event-edge-interpolated-intensity = The intensity where the scan line cuts edge { $upper }–{ $lower }: the nearer end weighs more.
event-edge-cut = Edge { $upper }–{ $lower } is cut at x_4 = { $x_4 }; nothing is interpolated.
event-span = A span begins: the pixels from { $first } on, up to but not including { $end }, have their centres between x_4 and x_5.
event-span-ends-normal = The normals at the two ends of the span.
event-span-ends-intensity = The intensities at the two ends of the span.
event-pixel = Pixel ({ $x }, { $y }) begins: its centre lies at x_P.
event-depth-tested-nearer = Nearer than what was drawn here before: it is drawn.
event-depth-tested-hidden = Not nearer than what was drawn here before: it stays hidden.
event-span-interpolated-normal = The normal of the pixel, between the two ends of the span; it is no longer of unit length.
event-span-interpolated-intensity = The intensity of the pixel, between the two ends of the span.
event-pixel-colored-own-normal = Pixel ({ $x }, { $y }) takes the intensity found at its own point with its own normal.
event-pixel-colored-textured = Pixel ({ $x }, { $y }) takes its textured intensity.
event-pixel-colored-summed = Pixel ({ $x }, { $y }) takes the ambient term and what each light adds.
event-pixel-colored-interpolated = Pixel ({ $x }, { $y }) takes its intensity.
event-pixel-colored-of-polygon = Pixel ({ $x }, { $y }) takes the one intensity of the polygon.
event-pixel-hidden = Pixel ({ $x }, { $y }) keeps what was drawn there before.
event-span-done = The span is done.
event-scan-line-done = Scan line { $y } is done.
event-middle = One intensity for the whole polygon, at the mean of its vertices.
event-vertex = Vertex { $vertex } comes up for the first time: its normal is the mean of the faces around it.
event-vertex-lit = The vertex has its intensity: it serves all polygons that share the vertex.
event-vertex-ready = The vertex has its normal: it serves all polygons that share the vertex.
event-pixel-point = P is the point of the polygon that the pixel shows: along u, the ray of the pixel, brought to the depth z.
event-pixel-normal = The interpolated normal is brought to unit length: between two unit vectors that differ it is shorter.
event-pixel-normal-lost = Here opposite normals cancel out, and their mean points nowhere: the normal of the face stands for it.
event-true-point = The ray of the pixel meets the true surface, before or behind its polygon, at P; N is the surface’s own normal there.
event-textured = The object’s own chart at P, and the texture’s colour there: what a ray through the pixel finds.
event-textured-linearly = Beside it the plain way: (u, v) of the corners, carried here linearly on the screen. Where the depth changes they are wrong.
event-texture-taken-linear = This picture is to show the mistake: the texture of the plain (u, v) is taken. It multiplies k_d alone.
event-texture-taken-exact = The texture at P is taken. It multiplies k_d alone.
event-texture-applied = The diffuse part of the intensity takes the texture; ambient and highlight stay as they are.
event-triangle = Triangle { $a }–{ $b }–{ $c } of the polygon begins: a normal that is linear over it, and a series for each cosine.
event-normal-at-middle = The series are expanded about the triangle's middle on the screen, with the normal N_0 there.
event-normal-slopes = What a pixel to the right and a row down add to the normal.
event-series-n-dot-l = N·L/|N| near the middle, up to second order: what every pixel's division and square root would find.
event-series-highlight = The highlight's cosine near the middle, up to second order.
event-light-expanded = Both cosines of light { $light } are polynomials now; its direction holds for the whole triangle.
event-expanded = Every light is expanded; the triangle can be filled.
event-differences-started = At the span's first pixel the polynomial gives the cosine and its two differences.
event-cosine-evaluated-n-dot-l = N·L at the pixel: two additions from the pixel before.
event-cosine-evaluated-highlight = The highlight's cosine at the pixel: two additions from the pixel before.
event-light-summed = What light { $light } adds here; the power of the highlight's cosine comes from a table.
event-triangle-done = Triangle { $a }–{ $b }–{ $c } is done.
event-edge-undrawn = The edge between vertices { $from } and { $to } is not drawn yet.
event-edge-clipped = The part of the edge within the frame, in pixels.
event-edge-unseen = Nothing of this edge is within the frame.
event-step-chosen = One pixel a step, along the longer of the two directions.
event-pixel-plotted = Pixel ({ $x }, { $y }) is plotted: the one in which the exact point lies.
event-edge-done = The edge is drawn.
event-primary-pixel = Pixel ({ $x }, { $y }) begins: a ray finds its colour.
event-through = The primary ray goes through this point of the picture plane, in pixels: the centre of the pixel, or of a cell of it.
event-pixel-colored-mean = The pixel takes the mean of what its rays brought back.
event-pixel-colored-of-ray = The pixel takes what its ray brought back.
event-search = The search begins: nothing is found yet, and { $objects } objects are to be tested.
event-object-tested-nearer = The ray meets object { $object } nearer than all before: it is NearestObject now, and t is NearestT.
event-object-tested-behind = The ray meets object { $object }, but not nearer than what was found before.
event-object-tested-missed = The ray misses object { $object }: NearestT stays.
event-light-tested-nearer = The ray meets the ball of light { $light } nearer than all objects.
event-light-tested-behind = The ball of light { $light } lies behind what was found before.
event-light-tested-missed = The ray misses the ball of light { $light }.
event-found-object = The search is over: object { $object } is the nearest.
event-found-light = The search is over: light { $light } itself is the nearest.
event-found-nothing = The search is over: the ray meets nothing.
event-between-tested-blocks = Object { $object } lies between the surface and the light.
event-between-tested-behind = Object { $object } lies behind the light: it does not block it.
event-between-tested-missed = The shadow ray misses object { $object }.
event-unshadowing = Object { $object } casts no shadow: it is passed over.
event-background = The ray leaves the scene: it takes the background colour.
event-light-met = The ray ends at light { $light }: it takes the light's colour.
event-surface-met = The point where the ray meets object { $object }, and the normal that points out of it.
event-faced-entering = The ray comes from outside, u · N < 0: the normal faces it already. θ_i is the angle of incidence.
event-faced-leaving = The ray comes from inside or from the back: the normal is turned toward it. θ_i is the angle of incidence.
event-surface-textured = The texture at this place; it multiplies k_d.
event-ray-primary = The primary ray begins at the eye O and goes through P_s, the point on the screen; u is its unit direction.
event-local = The local term: the light that arrives, and what the surface gives off itself.
event-returned = The light that comes back along the ray.
event-ray-reflected = The reflected ray begins, at level { $level }: it starts at the surface and goes the way R.
event-ray-transmitted = The transmitted ray begins, at level { $level }: it passes the surface and goes the way T.
event-ray-total-internal-reflection = Nothing passed the surface: this ray, at level { $level }, is its total internal reflection.
event-shadow-ray = A shadow ray goes to light { $light }, at the distance d: is anything nearer?
event-shadow-ray-infinitely-far = A shadow ray goes to light { $light }, which is infinitely far: does it meet anything?
event-shadow-blocked = In shadow: light { $light } does not arrive. What blocks it lies at t < d.
event-shadow-none = Nothing lies between: light { $light } arrives.
event-refraction-total-reflection = The surface is transparent, but the radicand is negative: total internal reflection. θ_c is the critical angle.
event-refraction-critical-angle = The surface is transparent, and the ray leaves the denser medium: it is bent away from the normal. θ_c is the critical angle.
event-refraction = The surface is transparent: the direction of the ray beyond follows from Snell's law.
event-transmission = The direction of the refracted ray.
event-total-internal-reflection = Nothing passes: the coefficient k_t goes with a ray in the mirror direction.
event-reflection = The surface reflects: u is mirrored at N.
event-branch-ended-depth = Level { $level } is the last one: this ray is not traced, and contributes black.
event-branch-ended-reflected = The surface does not reflect, k_r = 0: no reflected ray.
event-branch-ended-transmitted = The surface is not transparent, k_t = 0: no transmitted ray.
event-attenuated = The light of the secondary ray is weakened by the distance d to this surface.
event-branch-added-reflected = The light of the reflected ray is added.
event-branch-added-transmitted = The light of the transmitted ray is added.
event-reference = What the form factor is, by the contour integral to ten digits: the value that follows is compared with it.
event-form-factor = The form factor from patch { $i } to patch { $j }: the share of the light leaving patch { $i } that arrives at patch { $j }. V is 0 where something stands between.
event-faces-away = The two pieces lie behind each other or in one plane: nothing passes between them, and nothing is integrated.
event-pieces = The parts of the two patches that lie in front of each other, with { $corners_i } and { $corners_j } corners, and their areas.
event-chosen-area-to-area = Far from each other for their radii R: { $points } pairs of points are exact enough.
event-chosen-element-to-polygon = Apart, and one small: points of the smaller patch, each with its exact form factor to the larger one.
event-chosen-contour = Near or touching: the double contour integral.
event-points = A point of either patch, at a Gauss point.
event-pair = What the two points exchange, by their weights w: the nearer and the more they face each other, the more.
event-element = A point of the smaller patch stands for an element of it, with the weight w. It sees the other patch as a polygon.
event-polygon-edge = Edge { $edge } of the polygon, from its corner R_k on: seen from x it spans the angle |Γ_k|, and Γ_k is normal to it.
event-element-seen = The form factor of the element, exact for its point, is added by its weight.
event-edge-pair-at-right-angles = Edge { $edge_i } of one patch and edge { $edge_j } of the other are at right angles: they add nothing.
event-edge-pair-on-one-line = Edge { $edge_i } of one patch and edge { $edge_j } of the other lie on one line: I is exact. Lengths are in the extent L of the two.
event-edge-pair = Edge { $edge_i } of one patch with edge { $edge_j } of the other: I is exact along one, by Gauss points along the other. Lengths are in the extent L of the two.
event-ray-met = The ray meets the front of patch { $j }, and nothing before: it counts.
event-ray-missed = The ray does not reach patch { $j }: the hits stay as they are.
event-hemicube = A hemicube stands over the point x of patch { $i }: { $resolution } pixels along an edge of its top.
event-hemicube-pixel-top = Pixel ({ $pixel_x }, { $pixel_y }) of the top shows patch { $j }: it stands for ΔF.
event-hemicube-pixel-side = Pixel ({ $pixel_x }, { $pixel_y }) of side face { $face } shows patch { $j }: it stands for ΔF, less the lower it lies.
event-hemicube-seen = The form factor of the point; the mean over all n points of patch { $i } stands for the patch.
event-sight-blocked = Something stands between x and y: V(x, y) = 0. K is what they would exchange, cos θ_x cos θ_y / (π r^2).
event-sight-free = Nothing stands between x and y: V(x, y) = 1. K is what they exchange, cos θ_x cos θ_y / (π r^2).
event-seen = Seen from x, the other patch is clipped by what stands in front of it: F_x is the form factor of the whole, F_visible of what is left.
event-seen-nothing = From x nothing is seen of the other patch: all of it is hidden.
event-visible = By { $rays } points or lines of sight: the share of the light that nothing blocks.
event-form-factor-found-monte-carlo = The form factor: the share of n rays that met patch { $j }.
event-form-factor-found-hemicube = The form factor: the mean over the hemicubes.
event-form-factor-found = The form factor: the exchange, by the share that nothing blocks, over the area of patch { $i }.
event-room = The light of a room of { $n } patches is to be found: one system of equations for each channel of the colour.
event-room-done = All channels are done: every patch has its radiosity.
event-channel = The channel { $channel } begins: radiosity is monochrome, so each channel is solved by itself.
event-channel-left-out-like-another = The channel { $channel } has the reflectances and emissions of the channel { $like }: its solution serves both.
event-channel-left-out-dark = In the channel { $channel } nothing emits, so every radiosity is 0: there is nothing to solve.
event-channel-done = The channel { $channel } is done.
event-system = { $n } equations for { $n } radiosities, to be solved by { $solver }. μ, the largest gain of a row, says how much of the light is reflected at most.
event-started = Patch { $i } before the iteration: its radiosity, and its part r_i of the residual.
event-iteration = Iteration { $k } begins.
event-weighted-over-relaxation = Every patch goes ω times as far as it gathers, by Young’s ω for the bound μ.
event-weighted-first = The weight of the first iteration of Chebyshev is 1.
event-weighted-chebyshev = The weight of this iteration of Chebyshev, from the weight ω_old before; in the second iteration 2 stands for ω_old.
event-step-lengths = The step lengths of conjugate gradients: α along the direction p, and β for the next direction.
event-gathering = Patch { $i } gathers the light of all others: it emits E_i itself and reflects the share ρ_i of what arrives.
event-exchanged = Of the light that patch { $i } gathers, patch { $j } brings form factor times radiosity.
event-gathered-relaxed = Patch { $i } has gathered, and goes ω times as far as from the old radiosity to what it gathered.
event-gathered = Patch { $i } has gathered: its new radiosity is what it emits and what it reflects.
event-ambient-radiosity = The ambient radiosity: what the light not shot yet will come to in the mean, were the room evenly lit. ⟨…⟩ are means by area.
event-overshooting = Patch { $i } overshoots: its unshot radiosity, and the ambient in advance. Together, times A_i, they are the largest of all.
event-shooting = Patch { $i } shoots its unshot radiosity to all others: unshot_i A_i is the largest of all.
event-received = Patch { $j } receives, and reflects the share ρ_j: that is light it has not shot yet. F_j_i follows from the row of patch { $i } by reciprocity.
event-shot-done = The shot of patch { $i } is over: what it shot belongs to its radiosity now.
event-updated-chebyshev = Patch { $i }, changed with all others at once: B″ is its radiosity one iteration earlier, r the residual.
event-updated-direct = Patch { $i }: d solves the system for the residual, by elimination.
event-updated-along-direction = Patch { $i }, changed with all others at once, along the direction p.
event-iteration-done = The iteration is over: how large the residual is against the emission. ε_B bounds the error of every radiosity, where a bound is known.
event-converged = Converged after { $iterations } iterations: the residual is small enough.
event-not-converged = Not converged after { $iterations } iterations: this is no solution.

## what a scope is called

scope-frame = frame
scope-polygon = polygon
scope-illumination = illumination
scope-light = light
scope-edge-table = edge table
scope-scan-line = scan line
scope-edge = edge
scope-span = span
scope-pixel = pixel
scope-vertex = vertex
scope-triangle = triangle
scope-search = search
scope-ray = ray
scope-shadow-ray = shadow ray
scope-form-factor = form factor
scope-element = element
scope-hemicube = hemicube
scope-enclosure = enclosure
scope-channel = channel
scope-system = system
scope-iteration = iteration
scope-patch = patch

## notes beside formulas

note-as-on-the-slide = As on the slide, in place of f_{"{"}att{"}"} · (N·L); it grows with the distance:
note-incremental = By increments: the value before plus a constant step. Here it differs from the direct value by:
note-approximate = how far the series is from the cosine of a unit normal

## pseudocode

for-each-polygon = for each polygon
for-each-vertex-v-without-a-normal = for each vertex v without a normal
build-the-edge-table = build the edge table
for-each-scan-line-y = for each scan line y
for-each-active-edge = for each active edge
interpolate = interpolate
for-each-span-from-x-4-to-x-5 = for each span from x_4 to x_5
for-each-pixel-x-p = for each pixel x_P
if-nearer-than-the-depth-buffer = if nearer than the depth buffer
the-point-of-the-polygon-that-the-pixel-shows = the point of the polygon that the pixel shows
the-true-surface-behind-p = the true surface behind P
without-one = without one
for-each-vertex-v-not-yet-met = for each vertex v not yet met
for-each-triangle-of-it-about-its-middle = for each triangle of it, about its middle
toward-the-eye = toward the eye
turn-n-toward-v = turn N toward V
for-each-light = for each light
toward-the-light = toward the light
or = or
taylor-series-of-each-cosine-c = Taylor series of each cosine c
where-y-cuts-the-edge = where y cuts the edge
at-the-first-pixel-of-the-span = at the span's first pixel:
then-pixel-by-pixel = then, pixel by pixel:
mean-of-the-vertices = mean of the vertices
for-each-gauss-point-x-of-i-with-weight-w-x = for each Gauss point x of i, with weight w_x
for-each-gauss-point-y-of-j-with-weight-w-y = for each Gauss point y of j, with weight w_y
clip-each-to-the-front-of-the-other = clip i to the front of j, and j to the front of i
for-each-edge-of-i-with-direction-e = for each edge of i, with direction e
for-each-edge-of-j-with-direction-f = for each edge of j, with direction f
exact-along-s-else-by-gauss-points = exact along s;  exact along t on one line, else by Gauss points
for-each-gauss-point-x-of-i-with-weight-w = for each Gauss point x of i, with weight w
for-each-edge-of-j-seen-from-x = for each edge R_k, R_k+1 of j seen from x
angle-between-r-k-and-the-next = angle between R_k and R_k+1, along R_k × R_k+1
for-each-piece-of-i-and-of-j = for each piece of i and of j
clip-both-to-the-front-of-the-other-nothing-left-0 = clip both to the front of the other;  nothing left: 0
exchange-of-the-two = exchange of the two
share-that-nothing-blocks = share that nothing blocks
return = return
for-each-of-n-by-n-points-x-of-i = for each of n × n points x of i
draw-what-stands-in-the-way-onto-the-five-faces = draw what stands in the way onto the five faces, keeping the nearest
for-each-pixel-u-v-whose-centre-j-covers-nearest-of-all = for each pixel (u, v) whose centre j covers, nearest of all
on-top = on top
at-the-sides = at the sides
for-each-of-n-points-s-t-u-v-of-a-sobol-sequence = for each of n points (s, t, u, v) of a Sobol sequence
the-point-of-i-at-s-t = the point of i at (s, t)
direction = direction
across-n-i = across N_i
along-it = along it
if-the-ray-meets-the-front-of-j-and-nothing-before = if the ray meets the front of j and nothing before:
if-nothing-can-stand-between-return-1 = if no face can stand between i and j: return 1;  if one hides all: return 0
for-each-point-x-of-the-receiver = for each point x of one patch, more of them where the visible shape changes
form-factors-of-the-whole-and-of-what-no-face-hides = form factors of the whole other patch, and of what is left when the cones from x through the faces are cut away
point-of-i-at-s-t = point of i at (s, t)
point-of-j-at-u-v = point of j at (u, v)
whether-the-ray-from-x-to-y-meets-a-surface = whether the ray from x to y meets a surface
over-what-is-not-blocked = over what is not blocked
for-each-vertex-v-not-yet-lit = for each vertex v not yet lit
for = for
until = until
then = then
solve = solve
for-each-patch-i = for each patch i
for-each-patch-j = for each patch j
the-patch-of-largest = the patch of largest
what-it-received = what it received
means-by-area = means by area
for-each-pixel-in-the-projection-plane = for each pixel in the projection plane
ray-from-the-reference-point-through-the-pixel = ray from the reference point through the pixel
none = none
for-every-object-in-the-scene = for every object in the scene
if-the-ray-meets-it-nearer = if the ray meets it and t < NearestT
object = object
if-nothing-is-met = if NearestObject is none
background = background
otherwise = otherwise
emission = emission
if-nothing-is-met-return-background = if NearestObject is none: return background
shoot-a-ray-to-the-light-in-shadow-or-not = shoot a ray to the light: in shadow or not
ambient-and-light-that-arrives-and-emission = ambient + light that arrives + emission
if-the-surface-is-reflective = if the surface is reflective
if-it-is-transparent = if it is transparent
the-chart-of-the-object-at-p = the object's chart at P
colour-of-the-texture-at-u-v = colour of the texture at (u, v)
and-so = and so
for-each-edge-not-yet-drawn = for each edge not yet drawn
clip-the-edge-to-what-the-eye-sees = clip the edge to what the eye sees
rounded-up = rounded up
plot-the-pixel-at-x-y = plot the pixel at (x, y)
far-area-to-area = far, both small:       areaToArea
apart-element-to-polygon = apart, i small:        elementToPolygon
near-or-touching-contour = near or touching:      contour
code-at-line = Pseudocode, at the line: { $line }

## what kinds of events are called

kind-frame = Frame
kind-polygon = Polygon
kind-polygon-done = Polygon done
kind-frame-done = Frame done
kind-face-normal-added = Face normal added
kind-vertex-normal = Vertex normal
kind-file-normal = File normal
kind-normal-vanished = Normal vanished
kind-illumination = Illumination
kind-viewer = Viewer
kind-ambient = Ambient
kind-light = Light
kind-to-light = To light
kind-diffuse = Diffuse
kind-mirrored = Mirrored
kind-halfway = Halfway
kind-specular = Specular
kind-light-added = Light added
kind-illuminated = Illuminated
kind-edge-table = Edge table
kind-corner-placed = Corner placed
kind-edge-entered = Edge entered
kind-edge-skipped = Edge skipped
kind-edge-table-built = Edge table built
kind-scan-line = Scan line
kind-edge = Edge
kind-edge-ends = Edge ends
kind-edge-interpolated = Edge interpolated
kind-edge-cut = Edge cut
kind-span = Span
kind-span-ends = Span ends
kind-pixel = Pixel
kind-depth-tested = Depth tested
kind-span-interpolated = Span interpolated
kind-pixel-colored = Pixel coloured
kind-pixel-hidden = Pixel hidden
kind-span-done = Span done
kind-scan-line-done = Scan line done
kind-middle = Middle
kind-vertex = Vertex
kind-vertex-lit = Vertex lit
kind-vertex-ready = Vertex ready
kind-pixel-point = Pixel point
kind-pixel-normal = Pixel normal
kind-pixel-normal-lost = Pixel normal lost
kind-true-point = True point
kind-textured = Textured
kind-textured-linearly = Textured linearly
kind-texture-taken = Texture taken
kind-texture-applied = Texture applied
kind-triangle = Triangle
kind-normal-at-middle = Normal at middle
kind-normal-slopes = Normal slopes
kind-series = Series
kind-light-expanded = Light expanded
kind-expanded = Expanded
kind-differences-started = Differences started
kind-cosine-evaluated = Cosine evaluated
kind-light-summed = Light summed
kind-triangle-done = Triangle done
kind-edge-clipped = Edge clipped
kind-edge-unseen = Edge unseen
kind-step-chosen = Step chosen
kind-pixel-plotted = Pixel plotted
kind-edge-done = Edge done
kind-through = Through
kind-search = Search
kind-object-tested = Object tested
kind-light-tested = Light tested
kind-found = Found
kind-between-tested = Between tested
kind-unshadowing = Unshadowing
kind-background = Background
kind-light-met = Light met
kind-surface-met = Surface met
kind-faced = Faced
kind-ray = Ray
kind-local = Local
kind-returned = Returned
kind-shadow-ray = Shadow ray
kind-shadow = Shadow
kind-refraction = Refraction
kind-transmission = Transmission
kind-total-internal-reflection = Total internal reflection
kind-reflection = Reflection
kind-branch-ended = Branch ended
kind-attenuated = Attenuated
kind-branch-added = Branch added
kind-reference = Reference
kind-form-factor = Form factor
kind-faces-away = Faces away
kind-pieces = Pieces
kind-chosen = Chosen
kind-points = Points
kind-pair = Pair
kind-element = Element
kind-element-seen = Element seen
kind-edge-pair = Edge pair
kind-hemicube = Hemicube
kind-hemicube-seen = Hemicube seen
kind-sight = Sight
kind-seen = Seen
kind-visible = Visible
kind-form-factor-found = Form factor found
kind-room = Room
kind-room-done = Room done
kind-channel = Channel
kind-channel-left-out = Channel left out
kind-channel-done = Channel done
kind-system = System
kind-started = Started
kind-iteration = Iteration
kind-weighted = Weighted
kind-step-lengths = Step lengths
kind-gathering = Gathering
kind-exchanged = Exchanged
kind-gathered = Gathered
kind-shooting = Shooting
kind-received = Received
kind-shot-done = Shot done
kind-updated = Updated
kind-iteration-done = Iteration done
kind-converged = Converged
kind-not-converged = Not converged

## values that are words

value-red = red
value-green = green
value-blue = blue
value-jacobi = Jacobi’s iteration
value-gauss-seidel = Gauss–Seidel iteration
value-over-relaxation = successive over-relaxation
value-shooting = shooting
value-overshooting = overshooting
value-chebyshev = Chebyshev’s iteration
value-conjugate-gradients = conjugate gradients
value-direct = elimination
value-primary = primary
value-reflected = reflected
value-transmitted = transmitted
value-total-internal-reflection = total internal reflection
value-depth = depth
value-no-coefficient = no coefficient
value-nothing-emits = nothing emits
value-equal-channel = equal channel
value-at-right-angles = at right angles
value-on-one-line = on one line
value-by-gauss-points = by Gauss points
value-auto = auto
value-area-to-area = area to area
value-element-to-polygon = element to polygon
value-contour = contour
value-monte-carlo = Monte Carlo
value-hemicube = hemicube
value-nothing = nothing
value-light = light
value-object = object
value-unknown = unknown
value-n-dot-l = N·L
value-n-dot-h = N·H
value-r-dot-v = R·V

## what values mean

meaning-width = the width of the picture, in pixels
meaning-height = the height of the picture, in pixels
meaning-A = the intensity of the ambient light, the same everywhere in the scene
meaning-object = the number of the object in the scene
meaning-polygon = the number of the polygon in the scene
meaning-face = the number of the face in its object
meaning-face-of-Pixel = the face of the hemicube: 0 is its top, 1 to 4 are its sides
meaning-N_k = the unit normal of the face
meaning-sum_N = the sum of the unit normals of the faces so far
meaning-faces = how many faces share the vertex
meaning-length = the length of the sum of the face normals
meaning-length-of-PixelNormal = the length of the interpolated normal
meaning-length-of-PixelNormalLost = the length of the interpolated normal, too small to have a direction
meaning-N_v = the unit normal at the vertex: the mean direction of the faces around it
meaning-P = the point on the surface, in world coordinates
meaning-N = the unit normal of the surface at the point
meaning-N-of-CornerPlaced = the normal at the corner
meaning-N-of-Faced = the unit normal, turned toward the side from which the ray comes
meaning-N-of-PixelNormal = the interpolated normal, brought to unit length
meaning-N-of-PixelNormalLost = the unit normal of the face, in place of the interpolated one
meaning-N-of-TruePoint = the unit normal of the true surface at the point
meaning-V = the unit vector from the point to the viewer, or back along the ray
meaning-turned = whether the normal was turned to the side of the viewer
meaning-k_a = the ambient reflection coefficient of the material
meaning-I_a = the ambient term of the intensity
meaning-light = the number of the light in the scene
meaning-I_light = the intensity of the light, before attenuation
meaning-d = the distance from the point to the light; ∞ for a directional light
meaning-d-of-Attenuated = the length of the secondary ray, from this surface to where it ends
meaning-f_att = the attenuation factor: how the distance weakens the light
meaning-slide_factor = the factor d cos φ / √d of the lecture slide, in place of attenuation and cosine
meaning-L = the unit vector from the point to the light
meaning-N_dot_L = the cosine of the angle between the normal and the direction to the light
meaning-k_d = the diffuse reflection coefficient of the material
meaning-I_d = the diffuse term of the light
meaning-I_d-of-TextureApplied = the diffuse part of the intensity, which the texture multiplies
meaning-R = the direction to the light, mirrored at the normal
meaning-R-of-Reflection = the unit direction of the reflected ray
meaning-R-of-TotalInternalReflection = the unit direction of the ray after total internal reflection
meaning-R_dot_V = the cosine of the angle between the mirrored direction and the direction to the viewer
meaning-n_s = the specular exponent, or shininess: the larger, the narrower the highlight
meaning-H = the unit vector half-way between the directions to the light and to the viewer
meaning-N_dot_H = the cosine of the angle between the normal and the half-way vector
meaning-k_s = the specular reflection coefficient of the material
meaning-I_s = the specular term of the light: the highlight
meaning-I_added = what the light adds to the intensity of the point
meaning-I = the intensity of the point: the ambient term and what each light adds
meaning-I-of-CornerPlaced = the intensity at the corner
meaning-I-of-Returned = the intensity of the light that comes back along the ray
meaning-I-of-EdgePair = the double integral of ln r along the two edges
meaning-corners = how many corners the polygon has
meaning-corner = the number of the corner in the polygon
meaning-x = the column of the pixel, counted from the left
meaning-x-of-CornerPlaced = the horizontal position of the corner on the screen
meaning-x-of-Points = a point of one patch
meaning-x-of-Element = the point of the patch that stands for the element
meaning-x-of-Ray = the point of patch i from which the ray starts
meaning-x-of-Hemicube = the point of patch i at the centre of the hemicube
meaning-x-of-Sight = the point at one end of the line of sight
meaning-x-of-Seen = the point of one patch from which the other is seen
meaning-y = the row of pixels, counted from the top
meaning-y-of-CornerPlaced = the vertical position of the corner on the screen
meaning-y-of-Points = a point of the other patch
meaning-y-of-Sight = the point at the other end of the line of sight
meaning-z = the depth: how far in front of the eye, along the viewing direction
meaning-edge = the number of the edge in the polygon
meaning-upper = the number of the corner at the upper end of the edge
meaning-lower = the number of the corner at the lower end of the edge
meaning-first = the first pixel of the span
meaning-first-of-EdgeEntered = the first scan line that the edge cuts
meaning-end = the pixel after the last one of the span
meaning-end-of-EdgeEntered = the scan line after the last one that the edge cuts
meaning-dx_dy = how far the edge moves to the right from one scan line to the next
meaning-dI_dy = how much the intensity on the edge changes from one scan line to the next
meaning-dN_dy = how much the normal on the edge changes from one scan line to the next
meaning-from = the number of the corner where the edge begins
meaning-from-of-Edge = the number of the vertex where the edge begins
meaning-to = the number of the corner where the edge ends
meaning-to-of-Edge = the number of the vertex where the edge ends
meaning-edges = how many edges are in the table
meaning-y_4 = the height of the scan line on the screen: that of its pixel centres
meaning-y_1 = the vertical position of the upper end of the edge on the screen
meaning-y_1-of-EdgeClipped = the vertical position of the first end of the edge within the picture
meaning-y_2 = the vertical position of the lower end of the edge on the screen
meaning-y_2-of-EdgeClipped = the vertical position of the second end of the edge within the picture
meaning-x_4 = the horizontal position where the scan line cuts the edge
meaning-x_4-of-Span = the horizontal position of the left end of the span
meaning-I_1 = the intensity at the upper end of the edge
meaning-N_1 = the normal at the upper end of the edge
meaning-I_2 = the intensity at the lower end of the edge
meaning-N_2 = the normal at the lower end of the edge
meaning-I_4 = the intensity where the scan line cuts the edge
meaning-I_4-of-SpanEnds = the intensity at the left end of the span
meaning-N_4 = the normal where the scan line cuts the edge
meaning-N_4-of-SpanEnds = the normal at the left end of the span
meaning-I_4_incremental = the intensity where the scan line cuts the edge, from the scan line before plus a constant step
meaning-N_4_incremental = the normal where the scan line cuts the edge, from the scan line before plus a constant step
meaning-difference = the incremental value minus the direct one: what rounding makes of the additions
meaning-difference-of-CosineEvaluated = the cosine by differences minus the polynomial itself: what rounding makes of the additions
meaning-x_5 = the horizontal position of the right end of the span
meaning-I_5 = the intensity at the right end of the span
meaning-N_5 = the normal at the right end of the span
meaning-x_P = the horizontal position of the pixel’s centre
meaning-x_P-of-Through = the horizontal position of the point on the screen through which the ray goes
meaning-nearest = the depth of what was drawn at the pixel before; ∞ where there is nothing yet
meaning-nearer = whether it is nearer than everything before
meaning-I_P = the intensity at the pixel, between the two ends of the span
meaning-N_P = the interpolated normal at the pixel, not of unit length
meaning-I_P_incremental = the intensity at the pixel, from the pixel before plus a constant step
meaning-N_P_incremental = the interpolated normal at the pixel, from the pixel before plus a constant step
meaning-color = the colour of the pixel
meaning-color-of-Background = the colour of the background
meaning-color-of-LightMet = the colour of the light
meaning-u_texture = the texture coordinate u at the point
meaning-v_texture = the texture coordinate v at the point
meaning-texture = the colour of the texture at (u, v)
meaning-u_linear = the texture coordinate u, interpolated linearly on the screen
meaning-v_linear = the texture coordinate v, interpolated linearly on the screen
meaning-texture_linear = the colour of the texture at the linearly interpolated (u, v)
meaning-T = the colour of the texture that is taken
meaning-T-of-Transmission = the unit direction of the transmitted ray
meaning-linear = whether the texture at the linearly interpolated (u, v) is taken
meaning-I_textured = the intensity with the texture in its diffuse part
meaning-P_m = the mean of the polygon’s vertices
meaning-vertex = the number of the vertex in its object
meaning-P_v = the position of the vertex, in world coordinates
meaning-I_v = the intensity at the vertex
meaning-triangle = the number of the triangle in the polygon
meaning-a = the number of the triangle’s first corner
meaning-b = the number of the triangle’s second corner
meaning-c = the cosine at the pixel, by forward differences
meaning-c-of-Triangle = the number of the triangle’s third corner
meaning-x_0 = the horizontal position of the middle of the triangle on the screen
meaning-y_0 = the vertical position of the middle of the triangle on the screen
meaning-N_0 = the interpolated normal at the middle of the triangle
meaning-vanished = whether the vertex normals cancel out there, so that the normal of the face is taken
meaning-N_x = how much the normal changes from a pixel to the next one on the right
meaning-N_y = how much the normal changes from a row of pixels to the one below
meaning-cosine = which cosine of the illumination model it is
meaning-T_0 = the constant coefficient of the series, the cosine at the middle
meaning-T_1 = the coefficient of y in the series
meaning-T_2 = the coefficient of x in the series
meaning-T_3 = the coefficient of y² in the series
meaning-T_4 = the coefficient of xy in the series
meaning-T_5 = the coefficient of x² in the series
meaning-dc = the first forward difference: what the next pixel adds to the cosine
meaning-d2c = the second forward difference, constant along the span
meaning-c_direct = the cosine from the polynomial itself
meaning-c_exact = the exact cosine, with the normal brought to unit length
meaning-error = the cosine by differences minus the exact one
meaning-power = the highlight’s cosine raised to the specular exponent
meaning-x_1 = the horizontal position of the first end of the edge within the picture
meaning-x_2 = the horizontal position of the second end of the edge within the picture
meaning-n = how many patches the enclosure has
meaning-n-of-StepChosen = in how many steps the edge is drawn
meaning-dx = how far each step goes to the right
meaning-dy = how far each step goes down
meaning-x_exact = the horizontal position of the exact point on the edge
meaning-y_exact = the vertical position of the exact point on the edge
meaning-samples = the n of the n × n rays through the pixel
meaning-sample = the number of the ray among those of the pixel
meaning-y_P = the vertical position of the point on the screen through which the ray goes
meaning-objects = how many objects are to be tested
meaning-NearestT = the distance along the ray to the nearest hit so far; ∞ where there is none
meaning-t = the distance along the ray to where it meets the object; ∞ where it misses
meaning-t-of-LightTested = the distance along the ray to the ball of the light; ∞ where it misses
meaning-met = what the ray meets first
meaning-met-of-Ray = whether the ray meets the front of patch j first
meaning-blocks = whether the object blocks the light
meaning-N_geometric = the unit normal that points out of the object
meaning-cos_theta_i = the cosine of the angle of incidence
meaning-theta_i_degrees = the angle of incidence, between the normal and the way back along the ray
meaning-entering = whether the ray comes from outside the object
meaning-O = the origin of the ray
meaning-u = the unit direction of the ray
meaning-emission = the light that the surface emits itself
meaning-I_local = the local term: what the illumination model yields, and the emission
meaning-ray = the kind of ray
meaning-level = the level of the ray in the ray tree; the primary ray is at level 1
meaning-blocked = whether something stands between the surface and the light
meaning-blocked-of-Sight = whether something stands between the two points
meaning-blocker = the number of the object that blocks the light
meaning-I_sum = the intensity of the ray so far
meaning-eta_i = the refractive index of the medium in which the ray arrives
meaning-eta_r = the refractive index of the medium behind the surface
meaning-cos2_theta_r = the squared cosine of the angle of refraction; where it is negative, reflection is total
meaning-theta_r_degrees = the angle of refraction, between the transmitted ray and the normal
meaning-theta_c_degrees = the critical angle: beyond it the reflection is total
meaning-branch = the kind of the secondary ray
meaning-k_t = the transmission coefficient of the material
meaning-k_r = the reflection coefficient of the material for secondary rays
meaning-why = why there is no such ray
meaning-why-of-ChannelLeftOut = why the channel need not be solved
meaning-a_0 = the constant coefficient of the attenuation by distance
meaning-a_1 = the linear coefficient of the attenuation by distance
meaning-a_2 = the quadratic coefficient of the attenuation by distance
meaning-divisor = what the light of the secondary ray is divided by, because of the distance
meaning-carried = the light of the secondary ray that arrives, after attenuation
meaning-F_exact = the form factor, by the contour integral to ten digits
meaning-i = the number of the patch
meaning-i-of-FormFactor = the number of the patch that the light leaves
meaning-i-of-Gathering = the number of the patch that gathers
meaning-i-of-Gathered = the number of the patch that gathers
meaning-i-of-Shooting = the number of the patch that shoots
meaning-i-of-ShotDone = the number of the patch that shoots
meaning-j = the number of the patch whose light arrives
meaning-j-of-FormFactor = the number of the patch at which the light arrives
meaning-j-of-Received = the number of the patch that receives
meaning-method = the method by which the form factor is found
meaning-corners_i = how many corners the part of patch i has that faces patch j
meaning-corners_j = how many corners the part of patch j has that faces patch i
meaning-area_i = the area of the part of patch i that faces patch j
meaning-area_j = the area of the part of patch j that faces patch i
meaning-chosen = the method that the automatic choice takes
meaning-distance = the distance between the centres of the two patches
meaning-radius_i = the distance from the centre of patch i to its farthest corner
meaning-radius_j = the distance from the centre of patch j to its farthest corner
meaning-points = how many points, or pairs of points, the method takes; 0 where it decides by itself
meaning-cos_theta_x = the cosine of the angle at x between the normal and the line to y
meaning-cos_theta_y = the cosine of the angle at y between the normal and the line to x
meaning-r = the distance between the two points
meaning-term = what the pair of points adds to the sum
meaning-term-of-Edge = what the edge adds to the form factor of the element
meaning-sum = the exchange A_i F_ij so far
meaning-sum-of-Exchanged = the light that reaches patch i so far, Σ F_ij B_j
meaning-element = the number of the element among those of the form factor
meaning-w = the weight of the element: the area for which its point stands
meaning-R_k = the corner of the polygon where the edge begins
meaning-Gamma_k = the angle that the edge spans, seen from x
meaning-F_x = the form factor of the point x so far
meaning-F_x-of-ElementSeen = the form factor of the element
meaning-F_x-of-HemicubeSeen = the form factor of the point x
meaning-F_x-of-Seen = the form factor of the whole other patch, seen from the point x
meaning-F_visible = the form factor of what is visible from the point x: the part of the other patch that nothing hides
meaning-edge_i = the number of the edge of the first patch
meaning-edge_j = the number of the edge of the second patch
meaning-e_dot_f = the cosine of the angle between the two edges
meaning-way = how the integral is found
meaning-direction = the unit direction of the ray
meaning-hits = how many rays have met patch j so far
meaning-hemicube = the number of the hemicube among those of the patch
meaning-resolution = how many pixels lie along an edge of the hemicube’s top
meaning-pixel_x = the column of the pixel on its face of the hemicube
meaning-pixel_y = the row of the pixel on its face of the hemicube
meaning-delta_F = the delta form factor: the share of the light that the pixel stands for
meaning-F_mean = the mean over the hemicubes so far, each with its share
meaning-share = the share of the light that nothing blocks, so far
meaning-share-of-Visible = the share of the light that nothing blocks
meaning-rays = how many lines of sight were tested
meaning-A_i_F_ij = the exchange between the two patches: the area times the form factor, the same in both directions
meaning-F_ij = the form factor: the share of the light leaving patch i that arrives at patch j
meaning-channel = the channel of the colour
meaning-like = the channel whose solution serves this one too
meaning-solver = the method that solves the system
meaning-gain = the largest gain of a row, ρ_i Σ F_ij: how much of the light is reflected at most
meaning-B_i = the radiosity of patch i: the light that leaves it per area
meaning-unshot_i = the unshot radiosity of patch i: what it has not shot yet
meaning-unshot_i-of-Started = the residual of patch i: by how much its equation is not fulfilled yet
meaning-k = the number of the iteration, counted from 0
meaning-omega = the weight ω: how far a step goes, where 1 is a plain step
meaning-alpha = the step length along the search direction
meaning-beta = how much of this search direction goes into the next one
meaning-E_i = the emission of patch i: the radiosity that it emits itself
meaning-rho_i = the reflectance of patch i: the share of the arriving light that it reflects
meaning-B_old = the radiosity of patch i before this step
meaning-B_j = the radiosity of patch j: the light that leaves it per area
meaning-product = what patch j contributes: form factor times radiosity
meaning-DeltaB = how much the radiosity of patch i changes
meaning-DeltaB-of-Received = the radiosity that patch j gains from the shot
meaning-ambient = the ambient radiosity: the mean that the unshot light would come to in an evenly lit enclosure
meaning-shot = the radiosity that patch i shoots
meaning-A_i = the area of patch i
meaning-F_ji = the form factor from patch j to patch i
meaning-rho_j = the reflectance of patch j: the share of the arriving light that it reflects
meaning-unshot_j = the unshot radiosity of patch j: what it has not shot yet
meaning-residual = the norm of the residual, relative to that of the emission
meaning-error_bound = a bound on the error of every radiosity, where one is known
meaning-iterations = how many iterations were needed
meaning-iterations-of-NotConverged = how many iterations were made

## quantities whose symbol is a word

quantity-width = width
quantity-height = height
quantity-object = object
quantity-polygon = polygon
quantity-face = face
quantity-faces = faces
quantity-length = length
quantity-turned = turned
quantity-light = light
quantity-slide-factor = slide factor
quantity-corners = corners
quantity-corner = corner
quantity-edge = edge
quantity-upper = upper
quantity-lower = lower
quantity-first = first
quantity-end = end
quantity-from = from
quantity-to = to
quantity-edges = edges
quantity-i-4-incremental = I_4 incremental
quantity-n-4-incremental = N_4 incremental
quantity-difference = difference
quantity-nearest = nearest
quantity-nearer = nearer
quantity-i-p-incremental = I_P incremental
quantity-n-p-incremental = N_P incremental
quantity-color = color
quantity-texture = texture
quantity-texture-linear = texture linear
quantity-linear = linear
quantity-vertex = vertex
quantity-triangle = triangle
quantity-vanished = vanished
quantity-cosine = cosine
quantity-error = error
quantity-power = power
quantity-samples = samples
quantity-sample = sample
quantity-objects = objects
quantity-met = met
quantity-blocks = blocks
quantity-entering = entering
quantity-emission = emission
quantity-ray = ray
quantity-level = level
quantity-blocked = blocked
quantity-blocker = blocker
quantity-branch = branch
quantity-why = why
quantity-divisor = divisor
quantity-carried = carried
quantity-method = method
quantity-corners-i = corners i
quantity-corners-j = corners j
quantity-area-i = area i
quantity-area-j = area j
quantity-chosen = chosen
quantity-distance = distance
quantity-radius-i = radius i
quantity-radius-j = radius j
quantity-points = points
quantity-term = term
quantity-sum = sum
quantity-element = element
quantity-edge-i = edge i
quantity-edge-j = edge j
quantity-way = way
quantity-direction = direction
quantity-hits = hits
quantity-hemicube = hemicube
quantity-resolution = resolution
quantity-pixel-x = pixel x
quantity-pixel-y = pixel y
quantity-share = share
quantity-rays = rays
quantity-channel = channel
quantity-like = like
quantity-solver = solver
quantity-gain = gain
quantity-product = product
quantity-ambient = ambient
quantity-shot = shot
quantity-residual = residual
quantity-error-bound = error bound
quantity-iterations = iterations

## panels

names-point-light = point light
names-directional-light = directional light
symbol-old = old
names-light = light { $number }
names-numbered = { $kind } { $number }
names-background = background
names-ray-meets = { $ray } → { $thing }
inspector-step = step { $step }
inspector-step-and-depth = step { $step } · depth { $depth }
inspector-this-step = this step
inspector-more = … { $count } more
inspector-no-values = This step records no values.
time-line-at-step = Time line at step { $step } of { $steps }

## what methods are called

method-wireframe = wireframe
method-flat = flat
method-gouraud = Gouraud
method-phong = Phong
method-fast-phong = Fast Phong
method-ray-casting = ray casting
method-ray-tracing = ray tracing
method-radiosity = radiosity
method-exact = exact

## what the size of a setting counts, and what errors are errors of

measure-longitudes-of-a-sphere = longitudes of a sphere
measure-steps = steps
measure-levels = levels
measure-rays-along-a-pixel-s-side = rays along a pixel's side
measure-objects = objects
measure-distance-in-radii = distance, in radii
measure-samples = samples
measure-sweeps = sweeps
measure-patches-along-a-wall = patches along a wall
measure-pixels = pixels
measure-triangles = triangles
measure-patches = patches
measure-events = events
measure-intensity = intensity
measure-intensity-toward-the-viewer = intensity where N·V ≥ 0.6
measure-the-values-from-0-to-1 = the values from 0 to 1
measure-t-a-share-of-the-distance = t, a share of the distance
measure-radiosity-in-the-unit-of-the-emission = B, in the unit of the emission
measure-radiosity-at-the-finest-centres = B, at the centres of the finest patches
measure-form-factor = F
measure-nothing = nothing

## studies

study-patches = Radiosity by patches a wall
study-patches-about = How finely must walls be divided, and how exact must form factors be for that?
study-solvers = Solvers of the radiosity system
study-solvers-about = Which solver comes to a given error of B first? A sweep is an iteration, or as many shots as there are patches.
study-ray-samples = Ray methods by samples a pixel
study-ray-samples-about = How many rays a pixel are enough against jagged edges?
study-interpolation = Incremental against direct interpolation
study-interpolation-about = One addition a step, or the formula anew at every step: what does the addition save, and what does it lose?
study-shading = Shading methods by tessellation
study-shading-about = How many polygons does each shading method need, and how long does it take, until a ball looks as smooth as it is?
study-search = Every object in turn against the hierarchy
study-search-about = From how many objects on is a hierarchy worth it? Both ways find the same, so that there is no error.
study-precision = f32 against f64: hits on a far unit sphere
study-precision-about = Does the formula matter more than the precision? Rays come to a unit sphere from farther and farther away.
study-form-factors = Form-factor methods by samples
study-form-factors-about = Which way to a form factor is cheapest for a given error, where patches face each other, and where they touch? Of adaptive methods 1/tolerance counts as samples.
study-growth = How work grows
study-growth-about = What does twice the pixels, triangles, levels, patches or events cost?
study-ray-depth = Ray tracing by depth
study-ray-depth-about = How deep must rays be followed, and what does each level cost? The tracer has no adaptive cut: `path_attenuation` changes the picture, and makes a cut by depth harmless sooner.

## parts of studies

part-path-attenuation = path attenuation [{ $a0 }, { $a1 }, { $a2 }]
part-all-form-factors = All form factors of the scene, unobstructed
part-pixels = pixels
part-triangles = triangles of a ball, in 160×120 pixels
part-depth-of-rays = depth of rays
part-form-factors-of-a-cube = form factors of all patches of a cube
part-solving-a-cube = solving a cube to a residual of 1e-6
part-events = events of a Gouraud frame
part-steps = Steps
part-walls = Walls of n×n patches
part-distances = Distances
part-objects = Objects
part-spheres = Spheres as polygons
part-one-channel = One channel; a sweep is an iteration, or as many shots as patches
part-squares-at-distance-1 = Parallel squares at distance 1
part-squares-at-distance-0-1 = Parallel squares at distance 0.1
part-squares-with-a-common-edge = Squares with a common edge at 90°

## settings of studies

setting-depth = depth { $depth }
setting-steps = { $count } steps
setting-objects = { $count ->
    [one] { $count } object
   *[other] { $count } objects
 }
setting-shots = { $count } shots
setting-iterations = { $count ->
    [one] { $count } iteration
   *[other] { $count } iterations
 }
setting-rays = { $count } rays
setting-pixels = { $count } pixels
setting-triangles = { $count } triangles
setting-patches = { $count } patches
setting-events = { $count } events
setting-distance = distance { $distance }
setting-pairs = { $points }⁴ pairs
setting-points = { $points }² points
setting-tolerance = tolerance { $tolerance }

## curves of studies

curve-incremental-f32 = incremental, f32
curve-direct-f32 = direct, f32
curve-incremental-f64 = incremental, f64
curve-direct-f64 = direct, f64
curve-plain-roots-f32 = plain roots, f32
curve-stable-roots-f32 = stable roots, f32
curve-plain-roots-f64 = plain roots, f64
curve-brute-force = every object in turn
curve-hierarchy = hierarchy
curve-the-scene = the scene
curve-two-mirrors = two mirrors
curve-a-glass-ball = a glass ball
curve-recorded = recorded
curve-unrecorded = unrecorded
curve-hemicube-at-the-centre = hemicube at the centre
curve-4-by-4-hemicubes = 4×4 hemicubes
curve-hemicube-of-64-pixels = hemicube of 64 pixels

## references of studies, and how their own errors are known

reference-none = none: only time and memory are measured
reference-levels = the same picture with rays of up to { $deepest } levels
reference-last-step = what the last step to it changed: an upper bound where each step changes half as much as the one before, or less
reference-rounded-once = i/n in f64, rounded once
reference-half-a-unit = half a unit in the last place
reference-samples = the same picture with { $finest }×{ $finest } rays a pixel
reference-half-as-many = how far it is from half as many along each side: right where errors halve with that, else too large
reference-stable-roots = the stable roots in f64, for the same rays
reference-rounding = rounding
reference-elimination = elimination (LU) of { $count } patches, refined
reference-bound = the bound ‖r‖_∞ / (1 − max ρ_i Σ F_ij) on its residual
reference-finest-patches = the same room of { $finest }×{ $finest } patches a wall, by exact form factors
reference-richardson = a third of what the last halving of the patches changed (Richardson, second order)
reference-true-sphere = the true sphere, lit at each pixel with its true normal
reference-form-and-rounding = a closed form; what is left is rounding
reference-closed-form = F = { $f }, the closed form
reference-17-digits = known to 17 digits; what is left is rounding
reference-automatic-choice = the automatic choice at a tolerance of 1e-10
reference-tolerance = its tolerance

## what counts as memory in studies

memory-ramp = the values of the ramp, as f64
memory-objects = the objects with their hierarchy, and colour and depth of every pixel, counted by their sizes
memory-rays = the rays
memory-two-matrices = the matrix of form factors and four numbers a patch; elimination takes a second matrix of that size
memory-matrix-of-form-factors = the matrix of form factors
memory-matrix-and-hemicube = the matrix where there is one, and the pixels of a hemicube; counted by their sizes
memory-matrix = the matrix
memory-one-matrix = the matrix and four numbers a patch
memory-events = colour and depth of every pixel; recorded, the events with their marks and outline
memory-pictures = colour and depth of every pixel, the polygons with their vertices, and for rays the objects with their hierarchies, counted by their sizes

## how often something was done

operations-pixels = { $count } pixels
operations-polygons = { $count } polygons
operations-primary-rays = { $count } primary rays
operations-shadow-rays = { $count } shadow rays
operations-reflected-rays = { $count } reflected rays
operations-transmitted-rays = { $count } transmitted rays
operations-total-internal-reflections = { $count } total internal reflections
operations-steps = { $count } steps
operations-rays = { $count } rays
operations-iterations = { $count } iterations
operations-exchanges-gathered = { $count } exchanges gathered
operations-exchanges-shot = { $count } exchanges shot
operations-patches = { $count } patches
operations-form-factors = { $count } form factors
operations-events = { $count } events
operations-pairs-of-points = { $count } pairs of points
operations-edges-seen = { $count } edges seen
operations-pairs-of-edges = { $count } pairs of edges
operations-hemicube-pixels-of-the-patch = { $count } hemicube pixels of the patch

## objects in the scenes of studies

object-left = left mirror
object-right = right mirror
object-floor = floor
object-ball = ball
object-red-ball = red ball
object-glass-ball = glass ball

## plots of studies

study-time = time of a run (median)
study-rms-error = rms error of { $quantity }
study-own-error = the reference's own error
study-law-a-step = ×{ $factor } a step
study-heading-growth = Bars: quartiles. Exponents are those of the larger half of the sizes.
study-heading-reference = Reference: { $reference }.
study-heading-front = Reference: { $reference }. Bars: quartiles. Ringed, on the grey line: the Pareto front; no other setting is as quick and as exact.
study-point-error = { $setting } error { $error } in { $time }
study-point-time = { $setting } { $time }
study-no-result = No setting has a result.
