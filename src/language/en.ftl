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
app-last-said = Said before, at step { $step }
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
app-said-of-a-point = A point of a study: { $setting } came to an rms error of { $error } in { $time } on one thread. Here is the run behind it; the list of lessons leads back, and the menu to the study.
app-said-of-a-picture = A point of a study: { $setting } came to a picture in { $time } on one thread. Here is the run behind it; the list of lessons leads back, and the menu to the study.

## active-edges

active-edges-no-edges = No edge table is at hand at this step: each polygon builds its own. There each edge gets a row, and the active ones stand out.
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
matrix-gathers = { $patch } gathers row { $row }, sum of the row { $sum }
matrix-shoots = { $patch } shoots column { $column }

## panels

panels-no-steps = Nothing is recorded here: no polygon lies in the focus. Click the image to look at another place.
panels-no-polygons = This method follows rays and converts no polygons. Look at the ray tree.
panels-no-rays = This method converts polygons and follows no rays. Open a lesson on ray casting or ray tracing.
panels-no-patches = This run exchanges no light between patches. Open a lesson on radiosity.
panels-not-compared = The pictures to be compared are being made, or this lesson compares none.
panels-step = Step { $step }, { $kind }
panels-no-step = Step –
panels-step-and-values = { $step }: { $values }.
panels-yes = yes
panels-no = no

## profile

profile-intensity = intensity
profile-slope = its slope, a pixel (jumps of the value are cut off)
profile-seen = as it looks (lateral inhibition)
profile-line = scan line y = { $y }
profile-largest-jump = { $method }: largest jump of slope { $jump }

## race

race-iterations = iterations (n shots count as one)
race-time = seconds
race-error = relative error of B
race-running = The solvers are still running.
race-no-solution = This room has no solution, so nobody can win.
race-not-begun = The solvers wait at the start. Step to the end of an iteration.
race-gave-up = gave up
race-gave-up-after = gave up ({ $effort })
race-on-the-way = under way
race-patches = { $count } patches

## radiosity

radiosity-radiosity = radiosity B
radiosity-with-unshot = radiosity B + unshot
radiosity-unshot = unshot radiosity, { $channel }
radiosity-emission = emission E
radiosity-reflectance = reflectance ρ
radiosity-patches = Patches of the room: { $patches }, seen from their front, through the backs of those that turn away: { $seen }.
radiosity-current = Current patch: { $exchange }
radiosity-no-room = This scene cannot be divided into patches: a surface has no end, no area, or there are too many.
radiosity-red = red
radiosity-green = green
radiosity-blue = blue

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
ray-tree-asked = asked for
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
event-visible = Of { $rays } lines of sight: the share of the light that nothing blocks.
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
event-weighted-chebyshev = The weight of this iteration of Chebyshev, from the weight ω′ before; in the second iteration 2 stands for ω′.
event-step-lengths = The step lengths of conjugate gradients: α along the direction p, and β for the next direction.
event-gathering = Patch { $i } gathers the light of all others: it emits E_i itself and reflects the share ρ_i of what arrives.
event-exchanged = Of the light that patch { $i } gathers, patch { $j } brings form factor times radiosity.
event-gathered-relaxed = Patch { $i } has gathered, and goes ω times as far as from the old radiosity to what it gathered.
event-gathered = Patch { $i } has gathered: its new radiosity is what it emits and what it reflects.
event-ambient-radiosity = The ambient radiosity: what the light not shot yet will come to in the mean, were the room evenly lit. ⟨…⟩ are means by area.
event-overshooting = Patch { $i } overshoots: its unshot radiosity ΔB_i, and the ambient in advance. ΔB_i A_i with the ambient is the largest of all.
event-shooting = Patch { $i } shoots its unshot radiosity ΔB_i to all others: ΔB_i A_i is the largest of all.
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
if-nothing-can-stand-between-return-1 = if no group of patches can stand between i and j: return 1
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
kind-polygon-done = PolygonDone
kind-frame-done = FrameDone
kind-face-normal-added = FaceNormalAdded
kind-vertex-normal = VertexNormal
kind-file-normal = FileNormal
kind-normal-vanished = NormalVanished
kind-illumination = Illumination
kind-viewer = Viewer
kind-ambient = Ambient
kind-light = Light
kind-to-light = ToLight
kind-diffuse = Diffuse
kind-mirrored = Mirrored
kind-halfway = Halfway
kind-specular = Specular
kind-light-added = LightAdded
kind-illuminated = Illuminated
kind-edge-table = EdgeTable
kind-corner-placed = CornerPlaced
kind-edge-entered = EdgeEntered
kind-edge-skipped = EdgeSkipped
kind-edge-table-built = EdgeTableBuilt
kind-scan-line = ScanLine
kind-edge = Edge
kind-edge-ends = EdgeEnds
kind-edge-interpolated = EdgeInterpolated
kind-edge-cut = EdgeCut
kind-span = Span
kind-span-ends = SpanEnds
kind-pixel = Pixel
kind-depth-tested = DepthTested
kind-span-interpolated = SpanInterpolated
kind-pixel-colored = PixelColored
kind-pixel-hidden = PixelHidden
kind-span-done = SpanDone
kind-scan-line-done = ScanLineDone
kind-middle = Middle
kind-vertex = Vertex
kind-vertex-lit = VertexLit
kind-vertex-ready = VertexReady
kind-pixel-point = PixelPoint
kind-pixel-normal = PixelNormal
kind-pixel-normal-lost = PixelNormalLost
kind-true-point = TruePoint
kind-textured = Textured
kind-textured-linearly = TexturedLinearly
kind-texture-taken = TextureTaken
kind-texture-applied = TextureApplied
kind-triangle = Triangle
kind-normal-at-middle = NormalAtMiddle
kind-normal-slopes = NormalSlopes
kind-series = Series
kind-light-expanded = LightExpanded
kind-expanded = Expanded
kind-differences-started = DifferencesStarted
kind-cosine-evaluated = CosineEvaluated
kind-light-summed = LightSummed
kind-triangle-done = TriangleDone
kind-edge-clipped = EdgeClipped
kind-edge-unseen = EdgeUnseen
kind-step-chosen = StepChosen
kind-pixel-plotted = PixelPlotted
kind-edge-done = EdgeDone
kind-through = Through
kind-search = Search
kind-object-tested = ObjectTested
kind-light-tested = LightTested
kind-found = Found
kind-between-tested = BetweenTested
kind-unshadowing = Unshadowing
kind-background = Background
kind-light-met = LightMet
kind-surface-met = SurfaceMet
kind-faced = Faced
kind-ray = Ray
kind-local = Local
kind-returned = Returned
kind-shadow-ray = ShadowRay
kind-shadow = Shadow
kind-refraction = Refraction
kind-transmission = Transmission
kind-total-internal-reflection = TotalInternalReflection
kind-reflection = Reflection
kind-branch-ended = BranchEnded
kind-attenuated = Attenuated
kind-branch-added = BranchAdded
kind-reference = Reference
kind-form-factor = FormFactor
kind-faces-away = FacesAway
kind-pieces = Pieces
kind-chosen = Chosen
kind-points = Points
kind-pair = Pair
kind-element = Element
kind-element-seen = ElementSeen
kind-edge-pair = EdgePair
kind-hemicube = Hemicube
kind-hemicube-seen = HemicubeSeen
kind-sight = Sight
kind-visible = Visible
kind-form-factor-found = FormFactorFound
kind-room = Room
kind-room-done = RoomDone
kind-channel = Channel
kind-channel-left-out = ChannelLeftOut
kind-channel-done = ChannelDone
kind-system = System
kind-started = Started
kind-iteration = Iteration
kind-weighted = Weighted
kind-step-lengths = StepLengths
kind-gathering = Gathering
kind-exchanged = Exchanged
kind-gathered = Gathered
kind-shooting = Shooting
kind-received = Received
kind-shot-done = ShotDone
kind-updated = Updated
kind-iteration-done = IterationDone
kind-converged = Converged
kind-not-converged = NotConverged

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
quantity-vanished = vanished
quantity-cosine = cosine
quantity-error = error
quantity-power = power
quantity-samples = samples
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
quantity-edge-i = edge i
quantity-edge-j = edge j
quantity-way = way
quantity-direction = direction
quantity-hits = hits
quantity-resolution = resolution
quantity-pixel-x = pixel x
quantity-pixel-y = pixel y
quantity-share = share
quantity-rays = rays
quantity-channel = channel
quantity-like = like
quantity-solver = solver
quantity-gain = gain
quantity-unshot-i = unshot i
quantity-product = product
quantity-ambient = ambient
quantity-shot = shot
quantity-unshot-j = unshot j
quantity-residual = residual
quantity-error-bound = error bound
quantity-iterations = iterations

## panels

names-point-light = point light
names-directional-light = directional light
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

part-path-attenuation = path attenuation [{ $value }]
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
part-method = { $value }
part-objects = Objects
part-spheres = Spheres as polygons
part-one-channel = One channel; a sweep is an iteration, or as many shots as patches
part-squares-at-distance-1 = Parallel squares at distance 1
part-squares-at-distance-0-1 = Parallel squares at distance 0.1
part-squares-with-a-common-edge = Squares with a common edge at 90°

## plots of studies

study-time = time of a run (median)
study-rms-error = rms error of { $quantity }
study-own-error = the reference's own error
study-no-result = No setting has a result.
