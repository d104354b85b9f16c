### Semua teks program dalam bahasa Indonesia. Kunci menamai pesannya di setiap katalog; argumennya sama di semua katalog.

## focus

focus-frame = seluruh gambar
focus-polygon = poligon { $number }
focus-line = garis scan { $number }
focus-pixel = piksel ({ $x }, { $y })
focus-iterations = iterasi { $first }–{ $last }
focus-patch = patch { $number }

## common

common-error = galat
common-named = { $name }: { $what }
common-matrix-of-form-factors = Matriks faktor bentuk { $n } × { $n }.
common-light = cahaya
common-eye = mata
common-blocked = terhalang
common-blocked-by = terhalang oleh { $object }, t { $t }
common-relative-residual = residu relatif
common-total-internal-reflection = pemantulan internal total
common-level = tingkat { $level }

## app

app-present = Presentasi
app-share = Bagikan langkah
app-shared = Disalin: perintah yang membuka pelajaran ini pada langkah ini. { $command }
app-theme = Tema
app-theme-light = terang
app-theme-dark = gelap
app-theme-projector = proyektor
app-keys = tombol
app-keys-title = Tombol
app-close = Tutup
app-menu = Lainnya
app-questions = Ajukan pertanyaan
app-studies = Galat terhadap waktu eksekusi
app-study = Studi
app-quick = pengaturan sedikit dan kecil
app-measure = Ukur
app-call-off = Batalkan
app-back-to-the-run = Kembali ke pelajaran
app-measuring = mengukur { $percent } %
app-called-off = Dibatalkan; yang sudah masuk tetap ada.
app-no-findings = Tidak ada hasil: { $why }
app-nothing-measured = Pilih sebuah studi lalu ukur. Studi berjalan di latar belakang, pada satu utas.
app-debug-build = Ini build debug: waktunya tidak mengatakan apa-apa tentang algoritme.
app-study-plot = grafik studi
app-on-the-front = Di front Pareto: tidak ada pengaturan lain yang secepat dan seteliti ini.
app-point-time = waktu: { $median } (kuartil { $lower } – { $upper }, { $runs }×)
app-point-errors = galat: rms { $rms }, maks { $largest }, rel { $relative }
app-memory-is = memori { $bytes }
app-no-law = tidak ada hukum yang jelas
app-law-of-error = galat { $law }
app-law-of-time = waktu { $law }
app-click-opens-it = Klik membuka gambar dan jalannya.
app-measured-again-by = Tidak menghasilkan gambar. Diukur lagi, dengan baris tersendiri di tabel, oleh { $command }
app-reference = Acuan
app-pareto = Berlingkar, pada garis abu-abu: front Pareto. Batang: kuartil.
app-text-size = Ukuran teks
app-text-size-to = Ukuran teks { $size }
app-one-back = satu kejadian mundur
app-one-on = satu kejadian maju
app-step-of = langkah { $step } dari { $last }
app-steps-a-second = { $speed } langkah/dtk
app-loop = ulang { $from }–{ $to }
app-loop-off = tanpa ulang
app-loop-from-here = dari langkah ini
app-loop-to-here = sampai langkah ini
app-run-to = lompat ke
app-next-of-this-kind = berikutnya yang sejenis: { $kind }
app-search = cari
app-search-hint = EdgeInterpolated y=15
app-breakpoint = titik henti
app-truncated = Hanya awal dari proses ini yang muat di memori; gambarnya tetap utuh.
app-making-the-picture = seluruh gambar: { $percent } %
app-unsaid = Dengan nilai-nilai ini, sebagian dari yang dijelaskan pelajaran ini tidak terjadi.
app-put-back = Mulai lagi dengan nilai-nilai pelajaran
app-slide = Seperti pada slide
app-last-said = Sebelumnya, pada langkah { $step }
app-other-focus = Anda melihat bagian lain daripada pelajaran.
app-before-you-go-on = Sebelum melanjutkan
app-check = Periksa
app-skip = lewati
app-your-answer = Jawaban Anda
app-click-a-pixel = Klik piksel itu pada gambar.
app-right = Benar.
app-wrong = Belum tepat.
app-skipped = Dilewati.
app-the-answer-is = Jawabannya
app-show-the-step = tunjukkan langkah { $step } →
app-image = Gambar
app-scan-line = Garis scan
app-active-edges = Sisi aktif
app-vertex = Titik sudut
app-left-out = Ditinggalkan: tidak diperlukan di sini
app-left-out-about = Adegan ini tidak memerlukannya, maka tidak dikerjakan. Centang satu baris agar tetap dikerjakan: tidak ada yang berubah selain langkah dan waktunya.
app-nothing-left-out = Tidak ada: cara menggambar adegan ini memerlukan semua yang dikerjakannya.
app-is-needed = Itu diperlukan di sini, atau bukan bagian metode ini.
app-times-measured = mengukur …
app-times-none = terlalu lama untuk diukur di sini; “lightwalk needs” mengukurnya
app-times = ditinggalkan: { $without }   tetap dikerjakan: { $with }
app-times-tie = ditinggalkan: { $without }   tetap dikerjakan: { $with } (tidak ada beda di luar derau)
app-share-as-left-out-only = Langkahnya berbeda dari pelajaran selama sesuatu yang tidak diperlukan dikerjakan.
app-unsaid-anyway = Dengan hal itu tetap dikerjakan, pelajaran tidak menemukan langkah-langkahnya.
app-leave-out-again = Mulai lagi tanpa hal itu
app-ray-tree = Pohon sinar
app-vectors = Vektor di titik ini
app-radiosity = Radiositas, patch demi patch
app-form-factor = Faktor bentuk
app-convergence = Konvergensi
app-race = Para penyelesai berdampingan
app-comparison = Metode berdampingan
app-difference = Perbedaan
app-profile = Sepanjang garis scan
app-smooth = halus
app-smooth-room = interpolasikan cahaya antara sudut-sudut patch
app-illumination = Suku, dan faktor slide
app-rays = Sinar di dalam adegan
app-tree-fit = pas
app-whole-tree = tampilkan seluruh pohon
app-larger-tree = perbesar pohon
app-smaller-tree = perkecil pohon
app-tree-as-it-is = Pohon sudah tampil demikian.
app-inspector = Rincian
app-code = Kode
app-formula = Rumus
app-time-line = Garis waktu
app-click-a-row = klik baris untuk menyorotnya
app-drag-the-light = seret untuk memindahkan cahaya
app-drag-the-eye = seret untuk memindahkan mata
app-parameters = Parameter
app-put-back-all = nilai pelajaran
app-as-a-number = { $name } (sebagai angka)
app-distance = jarak { $thing }
app-from-the-target = dari yang dilihat kamera
app-divisions = pembagian { $object }
app-line = garis { $y }
app-polygon = poligon
app-frame = seluruh gambar
app-focus-on = Lihat
app-the-lessons-part = bagian pelajaran
app-at-the-start = Ini langkah pertama.
app-at-the-end = Ini langkah terakhir.
app-no-scope-ahead = Tidak ada lingkup lagi sesudah langkah ini.
app-no-scope-before = Tidak ada lingkup sebelum langkah ini.
app-nothing-around = Langkah ini tidak berada di dalam lingkup.
app-nothing-narrated-ahead = Tidak ada penjelasan lagi sesudah langkah ini.
app-nothing-narrated-before = Tidak ada penjelasan sebelum langkah ini.
app-answer-first = Jawab dahulu pertanyaannya, atau lewati.
app-no-question = Tidak ada pertanyaan pada langkah ini.
app-not-a-number = Itu bukan angka; tulis misalnya 0,52.
app-not-found = Tidak ada langkah yang cocok.
app-fastest = Ini yang tercepat.
app-slowest = Ini yang paling lambat.
app-no-loop = Belum ada ulangan; [ dan ] menentukannya.
app-nothing-under-pointer = Arahkan dahulu ke piksel, garis scan, atau poligon.
app-nothing-drawn-there = Tidak ada poligon pada piksel itu.
app-outside = Itu di luar gambar.
app-largest = Teks sudah terbesar.
app-smallest = Teks sudah terkecil.
app-no-such-lesson = Tidak ada pelajaran itu.
app-stays = Pelajaran ini membiarkannya seperti adanya.
app-still-measuring = Sebuah studi sedang diukur; batalkan dahulu.
app-nothing-is-measured = Tidak ada yang sedang diukur.
app-no-such-study = Tidak ada studi itu.
app-no-such-point = Tidak ada titik itu.
app-share-no-study = Titik sebuah studi hanya dapat dibuka dari studinya.
app-too-far = Itu terlalu jauh.
app-no-view = Dari sana tidak diketahui mana yang atas pada gambar.
app-out-of-range = Nilai itu tidak diperbolehkan.
app-share-unchanged-only = Sebuah parameter diubah: r mengembalikannya, lalu langkah ini dapat dibagikan.
app-share-lesson-only = Hanya langkah pelajaran yang dapat dibagikan; r kembali ke pelajaran.
app-said-of-a-point = Sebuah titik studi: { $setting } mencapai galat rms { $error } dalam { $time } pada satu utas. Inilah jalannya; daftar pelajaran membawa kembali, dan menu membuka studi.
app-said-of-a-picture = Sebuah titik studi: { $setting } mencapai satu gambar dalam { $time } pada satu utas. Inilah jalannya; daftar pelajaran membawa kembali, dan menu membuka studi.

## active-edges

active-edges-no-edges = Pada langkah ini tidak ada tabel sisi: setiap poligon membuat tabelnya sendiri. Di sana setiap sisi mendapat satu baris, dan sisi aktif ditonjolkan.
active-edges-no-table = Rangka kawat tidak memerlukan tabel sisi: sisinya digambar satu per satu. Buka pelajaran datar atau Gouraud.
active-edges-edge = sisi
active-edges-from = y dari
active-edges-to = y sampai
active-edges-a-line = Δ{ $value }/baris
active-edges-waits = menunggu
active-edges-done = selesai

## app-skipped

skipped-reflected-rays = Sinar pantul
skipped-reflected-rays-because = Tidak ada yang memantulkan.
skipped-transmitted-rays = Sinar bias
skipped-transmitted-rays-because = Tidak ada yang tembus cahaya.
skipped-texture-coordinates = Koordinat tekstur
skipped-texture-coordinates-because = Tidak ada yang bertekstur.
skipped-highlights = Sorotan
skipped-highlights-because = Tidak ada yang mengilap: tidak ada kosinus yang dipangkatkan.
skipped-light-balls = Bola cahaya
skipped-light-balls-because = Tidak ada sumber cahaya berjari-jari yang dapat ditemui sinar.
skipped-path-attenuation = Pelemahan di jalan
skipped-path-attenuation-because = Adegan tidak memintanya.
skipped-shadow-rays = Sinar bayangan
skipped-shadow-rays-because = Tidak ada yang dapat menghalangi objek-objek ini dari cahaya.
skipped-dark-channels = Kanal gelap
skipped-dark-channels-because = Tidak ada yang memancar di dalamnya: B = 0.
skipped-equal-channels = Kanal yang sama
skipped-equal-channels-because = Emisi dan reflektansinya sama dengan kanal sebelumnya: diselesaikan sekali.
skipped-black-rows = Persamaan patch hitam
skipped-black-rows-because = Mereka tidak memantulkan: B = E.
skipped-facing-away = Integral pasangan yang membelakangi
skipped-facing-away-because = Sebidang, atau yang satu di belakang yang lain: F = 0.
skipped-sight-tests = Sinar antarpatch
skipped-sight-tests-because = Tidak ada yang dapat menghalangi keduanya: semua cahaya lewat.
app-skipped-plane = { $object }: bidang tak terhingga tidak punya poligon
app-skipped-objects = { $some } dari { $all } objek
app-skipped-patches = { $some } dari { $all } patch
app-skipped-pairs = { $some } dari { $all } pasang patch

## comparison

comparison-illuminated = { $count } dihitung
comparison-interpolated = { $count } interpolasi
comparison-roots = { $count } akar
comparison-series = { $count } dari deret
comparison-rays = { $count } sinar
comparison-a-pixel = { $time } ns per piksel

## convergence

convergence-bound = batas galat B
convergence-iteration = iterasi k
convergence-none-yet = Belum ada iterasi yang selesai.
convergence-so-far = { $channel }: iterasi k { $k }, residu relatif { $residual }.
convergence-so-far-bounded = { $channel }: iterasi k { $k }, residu relatif { $residual }, batas galat B { $bound }.

## difference

difference-against = luminans dikurangi luminans { $method }
difference-rms = rms { $value }
difference-largest = maks { $value }
difference-here = di sini: { $value }

## form-factor

form-factor-no-pair = Proses ini mencari cahaya semua patch. Pilih satu faktor bentuk untuk melihat cara mencarinya.
form-factor-exact = acuan
form-factor-hits = mengenai j: { $part } dari { $all }
form-factor-free = tak terhalang: { $part } dari { $all }

## illumination

illumination-nothing = Saat sebuah titik diberi pencahayaan, panel ini menampilkan suku-suku intensitasnya. Pada langkah ini tidak ada.
illumination-no-light = Proses ini tidak memberi pencahayaan pada titik. Buka pelajaran tentang pencahayaan.
illumination-standard = baku
illumination-slide = slide
illumination-ratio = slide : baku
illumination-factor = faktor
illumination-distance = jarak d

## formula

formula-no-formula = Langkah ini tidak memiliki rumus. Lanjutkan ke langkah berikutnya.

## image

image-only = fokus: { $focus }
image-drawn = piksel yang sudah digambar: { $count }.

## keys

keys-next-event = kejadian berikutnya
keys-event-before = kejadian sebelumnya
keys-ten-events-on = sepuluh kejadian maju
keys-ten-events-back = sepuluh kejadian mundur
keys-next-scope = lingkup berikutnya
keys-previous-scope = lingkup sebelumnya
keys-into-the-scope = masuk ke lingkup
keys-out-of-the-scope = keluar dari lingkup
keys-over-the-scope = lewati lingkup
keys-first-step = langkah pertama
keys-last-step = langkah terakhir
keys-next-explained-step = langkah berikut yang dijelaskan
keys-explained-step-before = langkah dijelaskan sebelumnya
keys-play-or-pause = putar atau jeda
keys-play-backwards = putar mundur
keys-slower = lebih lambat
keys-faster = lebih cepat
keys-loop-from-this-step = ulang dari langkah ini
keys-loop-to-this-step = ulang sampai langkah ini
keys-breakpoint-here = titik henti di sini
keys-look-at-what-the-pointer = lihat yang ditunjuk
keys-start-the-lesson-over = ulangi pelajaran dari awal
keys-inspector = rincian
keys-questions-on-or-off = pertanyaan aktif atau tidak
keys-english-or-indonesian = bahasa Inggris atau Indonesia
keys-next-theme = tema berikutnya
keys-presentation = presentasi
keys-end-the-presentation = akhiri presentasi
keys-larger-text = teks lebih besar
keys-smaller-text = teks lebih kecil
keys-normal-text = teks normal
keys-copy-the-command-that-opens = salin perintah pembuka langkah ini
keys-skip-the-question = lewati pertanyaan
keys-error-against-run-time = galat terhadap waktu eksekusi
keys-all-keys = semua tombol

## matrix

matrix-no-matrix = Proses ini mencari satu faktor bentuk, bukan semuanya. Buka pelajaran tentang penyelesaian radiositas.
matrix-no-room = Adegan ini tidak memiliki patch: radiositas memerlukan permukaan yang terbatas.
matrix-gathers = { $patch } mengumpulkan baris { $row }, jumlah baris { $sum }
matrix-shoots = { $patch } menembakkan kolom { $column }

## panels

panels-no-steps = Tidak ada yang direkam di sini: tidak ada poligon dalam fokus. Klik gambar untuk melihat tempat lain.
panels-no-polygons = Metode ini mengikuti sinar dan tidak mengolah poligon. Lihatlah pohon sinar.
panels-no-rays = Metode ini mengolah poligon dan tidak mengikuti sinar. Buka pelajaran tentang ray casting atau ray tracing.
panels-no-patches = Proses ini tidak mempertukarkan cahaya antar-patch. Buka pelajaran tentang radiositas.
panels-not-compared = Gambar-gambar yang dibandingkan sedang dibuat, atau pelajaran ini tidak membandingkan apa pun.
panels-step = Langkah { $step }, { $kind }
panels-no-step = Langkah –
panels-step-and-values = { $step }: { $values }.
panels-yes = ya
panels-no = tidak

## profile

profile-intensity = intensitas
profile-slope = kemiringannya, per piksel (lompatan nilai dipotong)
profile-seen = seperti terlihat (inhibisi lateral)
profile-line = garis scan y = { $y }
profile-largest-jump = { $method }: lompatan kemiringan terbesar { $jump }

## race

race-iterations = iterasi (n tembakan dihitung satu)
race-time = detik
race-error = galat relatif B
race-running = Para penyelesai masih berjalan.
race-no-solution = Ruangan ini tidak punya solusi, jadi tidak ada pemenang.
race-not-begun = Para penyelesai menunggu di garis mulai. Melangkahlah sampai akhir sebuah iterasi.
race-gave-up = menyerah
race-gave-up-after = menyerah ({ $effort })
race-on-the-way = di jalan
race-patches = { $count } patch

## radiosity

radiosity-radiosity = radiositas B
radiosity-with-unshot = radiositas B + belum ditembakkan
radiosity-unshot = radiositas belum ditembakkan, { $channel }
radiosity-emission = emisi E
radiosity-reflectance = reflektansi ρ
radiosity-patches = Patch ruangan: { $patches }, terlihat dari depan, menembus punggung patch yang membelakangi: { $seen }.
radiosity-current = Patch saat ini: { $exchange }
radiosity-no-room = Adegan ini tidak dapat dibagi menjadi patch: ada permukaan tanpa batas, tanpa luas, atau jumlahnya terlalu banyak.
radiosity-red = merah
radiosity-green = hijau
radiosity-blue = biru

## ray-tree

ray-tree-no-ray = Begitu sebuah sinar dikirim lewat piksel, panel ini menggambar pohon semua sinar pembentuk warnanya. Pada langkah ini belum ada: lanjutkan.
ray-tree-no-rays = Metode ini mengolah poligon dan tidak mengikuti sinar. Buka pelajaran ray casting atau ray tracing untuk melihat pohon sinar sebuah piksel.
ray-tree-inside = { $object }, di dalam
ray-tree-background = latar belakang
ray-tree-leaves = keluar dari adegan
ray-tree-leaves-short = keluar
ray-tree-light-met = mengenai cahaya
ray-tree-searching = mencari …
ray-tree-not-traced = belum ditelusuri
ray-tree-asked = diminta
ray-tree-no-transmitted = tanpa sinar bias
ray-tree-depth-reached = batas kedalaman
ray-tree-no-coefficient = tanpa koefisien
ray-tree-rays = { $count } sinar
ray-tree-hidden = { $count } tak tampak
ray-tree-level = tingkat { $level } dari { $deepest }
ray-tree-shadow-rays = Sinar bayangan di { $thing }
ray-tree-lights = Cahaya di { $thing }
ray-tree-coming-back = Kembali ke atas
ray-tree-blocked = { $light } terhalang
ray-tree-blocked-by = { $light } terhalang oleh { $object }
ray-tree-clear = { $light } bebas
ray-tree-clear-at = bebas, d { $distance }
ray-tree-so-far = sejauh ini { $light }
ray-tree-nearest = terdekat: { $thing }, t { $t }
ray-tree-tested = diuji: { $thing }, t { $t }
ray-tree-missed = diuji: { $thing }, meleset

## rays

rays-side = dari samping
rays-above = dari atas
rays-rays = Sinar piksel sejauh ini: { $count }. Sinar saat ini: { $kind }, tingkat { $level }{ $goal }.
rays-no-pixel = Belum ada sinar yang diikuti. Lanjutkan ke piksel pertama.
rays-plane = bidang gambar

## scan-line

scan-line-no-polygon = Tidak ada poligon pada langkah ini. Lanjutkan (→) ke poligon berikutnya: sisi, garis scan, dan rentangnya tampil di sini.
scan-line-no-weights = Bobot interpolasi tampil di sini.
scan-line-no-line = Tidak ada sisi yang digambar pada langkah ini. Lanjutkan (→) ke sisi berikutnya: garis dan pikselnya tampil di sini.
scan-line-weights = bobot
scan-line-ramp = gradasi
scan-line-direct = langsung
scan-line-incremental = inkremental
scan-line-difference = selisih

## vectors

vectors-not-yet = Sinar ini belum mengenai permukaan. Lanjutkan sampai objek terdekat ditemukan.
vectors-no-point = Saat sebuah titik diberi pencahayaan, panel ini menampilkan vektor-vektornya. Pada langkah ini tidak ada.
vectors-no-surface = Sinar ini tidak mengenai permukaan: mendapat warna latar belakang atau cahaya. Klik sebuah objek pada gambar.
vectors-angles = { $surface } · sudut dengan N
vectors-arrives = sampai
vectors-away = di balik permukaan
vectors-leans = { $angle } keluar bidang
vectors-critical = kritis
vectors-no-t = tanpa T
vectors-air = udara

## vertex

vertex-nothing = Saat sebuah titik diberi pencahayaan, panel ini menampilkan normal, vektor ke sumber cahaya dan mata, serta suku intensitasnya. Pada langkah ini tidak ada.
vertex-wireframe = Rangka kawat tidak diberi pencahayaan: hanya sisi yang digambar. Buka pelajaran datar atau Gouraud.

## what a step does

event-frame = Gambar dimulai: { $width } × { $height } piksel, dengan cahaya ambien A.
event-polygon = Poligon { $polygon } dimulai; bagian dari objek { $object }.
event-polygon-done = Poligon { $polygon } selesai.
event-frame-done = Gambar selesai.
event-face-normal-added = Muka { $face } memiliki titik sudut ini: normal satuannya ditambahkan.
event-vertex-normal = Normal titik sudut: arah rata-rata normal muka, sepanjang satu satuan.
event-file-normal = Normal yang diberikan berkas jala poligon untuk sudut ini.
event-normal-vanished = Normal muka saling meniadakan: normal pertama menggantikan rata-ratanya.
event-illumination = Model pencahayaan di titik P dengan normal satuan N.
event-viewer-along-ray = Arah balik sepanjang sinar menggantikan arah ke mata.
event-viewer-turned = Mata melihat sisi sebaliknya: N dibalik ke arahnya.
event-viewer = Vektor satuan dari titik ke mata; N sudah di sisi yang sama.
event-ambient = Suku ambien: cahaya dari segala arah.
event-light = Cahaya { $light } pada jarak d, dilemahkan oleh atenuasi f_{"{"}att{"}"}.
event-light-infinitely-far = Cahaya { $light } jauh tak berhingga: tidak ada pelemahan.
event-to-light = Vektor satuan ke cahaya, dan kosinusnya dengan normal.
event-diffuse = Suku difus: sebanding dengan kosinus antara normal dan cahaya.
event-mirrored = Arah cahaya dicerminkan pada normal, dan kosinusnya dengan arah mata (Phong).
event-halfway = Tengah antara cahaya dan mata, dan kosinusnya dengan normal (Blinn).
event-specular-none = Tanpa sorotan: cahaya di balik permukaan, N·L ≤ 0.
event-specular = Suku spekular: sorotan, makin sempit bila n makin besar.
event-light-added-blocked = Cahaya terhalang: tidak menambah apa pun.
event-light-added-matte = Yang ditambahkan cahaya { $light }; tidak ada permukaan dengan sorotan di adegan ini.
event-light-added = Yang ditambahkan cahaya { $light } pada intensitas.
event-illuminated = Intensitas titik: suku ambien dan yang ditambahkan tiap cahaya.
event-edge-table = Tabel sisi dari poligon dengan { $corners } sudut dimulai.
event-corner-placed = Sudut { $corner } di layar, dalam piksel; z kedalamannya.
event-edge-entered = Sisi { $upper }–{ $lower } dimasukkan: memotong garis scan mulai { $first } sampai sebelum { $end }.
event-edge-skipped = Sisi { $from }–{ $to } tidak melewati pusat baris mana pun: dilewati.
event-edge-table-built = Tabel sisi selesai; jumlah sisi: { $edges }.
event-scan-line = Garis scan { $y } dimulai: pusat pikselnya pada y_4 = { $y_4 }.
event-edge = Garis scan memotong sisi { $upper }–{ $lower } di x_4.
event-edge-ends-normal = Normal di kedua ujung sisi { $upper }–{ $lower }.
event-edge-ends-intensity = Intensitas di kedua ujung sisi { $upper }–{ $lower }.
event-edge-interpolated-normal = Normal di potongan garis scan dengan sisi { $upper }–{ $lower }: ujung yang lebih dekat lebih berbobot.
event-edge-interpolated-intensity = Intensitas di potongan garis scan dengan sisi { $upper }–{ $lower }: ujung yang lebih dekat lebih berbobot.
event-edge-cut = Sisi { $upper }–{ $lower } terpotong di x_4 = { $x_4 }; tidak ada interpolasi.
event-span = Bentang dimulai: piksel mulai { $first } sampai sebelum { $end } berpusat di antara x_4 dan x_5.
event-span-ends-normal = Normal di kedua ujung bentang.
event-span-ends-intensity = Intensitas di kedua ujung bentang.
event-pixel = Piksel ({ $x }, { $y }) dimulai: pusatnya di x_P.
event-depth-tested-nearer = Lebih dekat daripada yang sudah digambar di sini: digambar.
event-depth-tested-hidden = Tidak lebih dekat daripada yang sudah digambar di sini: tersembunyi.
event-span-interpolated-normal = Normal piksel, di antara kedua ujung bentang; panjangnya tidak lagi satu satuan.
event-span-interpolated-intensity = Intensitas piksel, di antara kedua ujung bentang.
event-pixel-colored-own-normal = Piksel ({ $x }, { $y }) mendapat intensitas di titiknya sendiri, dengan normalnya sendiri.
event-pixel-colored-textured = Piksel ({ $x }, { $y }) mendapat intensitas bertekstur.
event-pixel-colored-summed = Piksel ({ $x }, { $y }) mendapat suku ambien dan tambahan tiap cahaya.
event-pixel-colored-interpolated = Piksel ({ $x }, { $y }) mendapat intensitasnya.
event-pixel-colored-of-polygon = Piksel ({ $x }, { $y }) mendapat intensitas poligon.
event-pixel-hidden = Piksel ({ $x }, { $y }) tetap seperti semula.
event-span-done = Bentang selesai.
event-scan-line-done = Garis scan { $y } selesai.
event-middle = Satu intensitas untuk seluruh poligon, pada rata-rata titik sudutnya.
event-vertex = Titik sudut { $vertex } muncul pertama kali: normalnya adalah rata-rata muka di sekelilingnya.
event-vertex-lit = Titik sudut mendapat intensitasnya, untuk semua poligon yang memakainya.
event-vertex-ready = Titik sudut mendapat normalnya, untuk semua poligon yang memakainya.
event-pixel-point = P adalah titik poligon yang tampak di piksel: sepanjang u, sinar piksel itu, sampai kedalaman z.
event-pixel-normal = Normal hasil interpolasi dijadikan satuan: di antara dua vektor satuan yang berbeda ia lebih pendek.
event-pixel-normal-lost = Di sini normal yang berlawanan saling meniadakan: normal muka menggantikannya.
event-true-point = Sinar piksel mengenai permukaan sebenarnya, di depan atau di belakang poligonnya, di P; N adalah normal permukaan itu sendiri.
event-textured = Peta objek itu sendiri di P, dan warna tekstur di sana: yang juga ditemukan sinar melalui piksel.
event-textured-linearly = Di sampingnya cara polos: (u, v) sudut, dibawa ke sini secara linear di layar. Bila kedalaman berubah, nilainya salah.
event-texture-taken-linear = Gambar ini menunjukkan kesalahannya: dipakai tekstur dari (u, v) polos. Tekstur hanya mengalikan k_d.
event-texture-taken-exact = Dipakai tekstur di P. Tekstur hanya mengalikan k_d.
event-texture-applied = Bagian difus dari intensitas dikalikan tekstur; ambien dan sorotan tetap.
event-triangle = Segitiga { $a }–{ $b }–{ $c } dari poligon dimulai: satu normal linear dan satu deret untuk tiap kosinus.
event-normal-at-middle = Deret dikembangkan di tengah segitiga pada layar, dengan normal N_0 di sana.
event-normal-slopes = Tambahan pada normal untuk satu piksel ke kanan dan satu baris ke bawah.
event-series-n-dot-l = N·L/|N| di sekitar titik tengah, sampai orde kedua: pengganti pembagian dan akar tiap piksel.
event-series-highlight = Kosinus sorotan di sekitar titik tengah, sampai orde kedua.
event-light-expanded = Kedua kosinus cahaya { $light } kini polinomial; arahnya berlaku untuk seluruh segitiga.
event-expanded = Semua cahaya sudah dikembangkan; segitiga dapat diisi.
event-differences-started = Pada piksel pertama bentang, polinomial memberi kosinus dan kedua selisihnya.
event-cosine-evaluated-n-dot-l = N·L di piksel: dua penjumlahan dari piksel sebelumnya.
event-cosine-evaluated-highlight = Kosinus sorotan di piksel: dua penjumlahan dari piksel sebelumnya.
event-light-summed = Tambahan cahaya { $light } di sini; pangkat kosinus sorotan diambil dari tabel.
event-triangle-done = Segitiga { $a }–{ $b }–{ $c } selesai.
event-edge-undrawn = Sisi antara titik sudut { $from } dan { $to } belum digambar.
event-edge-clipped = Bagian sisi yang di dalam gambar, dalam piksel.
event-edge-unseen = Tidak ada bagian sisi ini di dalam gambar.
event-step-chosen = Satu piksel tiap langkah, sepanjang arah yang lebih panjang.
event-pixel-plotted = Piksel ({ $x }, { $y }) digambar: piksel yang memuat titik tepatnya.
event-edge-done = Sisi selesai digambar.
event-primary-pixel = Piksel ({ $x }, { $y }) dimulai: sebuah sinar mencari warnanya.
event-through = Sinar primer melewati titik bidang gambar ini, dalam piksel: pusat piksel, atau pusat sel di dalamnya.
event-pixel-colored-mean = Piksel mendapat rata-rata dari yang dibawa kembali sinar-sinarnya.
event-pixel-colored-of-ray = Piksel mendapat yang dibawa kembali sinarnya.
event-search = Pencarian dimulai: belum ada yang ditemukan, { $objects } objek akan diuji.
event-object-tested-nearer = Sinar mengenai objek { $object } lebih dekat dari semua sebelumnya: kini NearestObject, dan t menjadi NearestT.
event-object-tested-behind = Sinar mengenai objek { $object }, tetapi tidak lebih dekat dari yang sudah ditemukan.
event-object-tested-missed = Sinar meleset dari objek { $object }: NearestT tetap.
event-light-tested-nearer = Sinar mengenai bola cahaya { $light } lebih dekat dari semua objek.
event-light-tested-behind = Bola cahaya { $light } berada di balik yang sudah ditemukan.
event-light-tested-missed = Sinar meleset dari bola cahaya { $light }.
event-found-object = Pencarian selesai: objek { $object } yang terdekat.
event-found-light = Pencarian selesai: cahaya { $light } sendiri yang terdekat.
event-found-nothing = Pencarian selesai: sinar tidak mengenai apa pun.
event-between-tested-blocks = Objek { $object } berada di antara permukaan dan cahaya.
event-between-tested-behind = Objek { $object } berada di balik cahaya: tidak menghalangi.
event-between-tested-missed = Sinar bayangan meleset dari objek { $object }.
event-unshadowing = Objek { $object } tidak membuat bayangan: dilewati.
event-background = Sinar keluar dari adegan: mendapat warna latar belakang.
event-light-met = Sinar berakhir di cahaya { $light }: mendapat warna cahaya itu.
event-surface-met = Titik tempat sinar mengenai objek { $object }, dan normal yang mengarah ke luar.
event-faced-entering = Sinar datang dari luar, u · N < 0: normal sudah menghadapnya. θ_i adalah sudut datang.
event-faced-leaving = Sinar datang dari dalam atau dari belakang: normal dibalik ke arahnya. θ_i adalah sudut datang.
event-surface-textured = Tekstur di tempat ini; dikalikan dengan k_d.
event-ray-primary = Sinar primer mulai dari mata O melewati P_s, titik di layar; u arah satuannya.
event-local = Suku lokal: cahaya yang sampai, dan yang dipancarkan permukaan sendiri.
event-returned = Cahaya yang kembali sepanjang sinar.
event-ray-reflected = Sinar pantul dimulai, pada tingkat { $level }: dari permukaan ke arah R.
event-ray-transmitted = Sinar bias dimulai, pada tingkat { $level }: menembus permukaan ke arah T.
event-ray-total-internal-reflection = Tidak ada yang menembus permukaan: sinar ini, pada tingkat { $level }, adalah pemantulan internal totalnya.
event-shadow-ray = Sinar bayangan menuju cahaya { $light }, pada jarak d: adakah yang lebih dekat?
event-shadow-ray-infinitely-far = Sinar bayangan menuju cahaya { $light } yang jauh tak berhingga: adakah yang dikenainya?
event-shadow-blocked = Dalam bayangan: cahaya { $light } tidak sampai. Penghalangnya pada t < d.
event-shadow-none = Tidak ada yang menghalangi: cahaya { $light } sampai.
event-refraction-total-reflection = Permukaan tembus pandang, tetapi radikannya negatif: pemantulan internal total. θ_c adalah sudut kritis.
event-refraction-critical-angle = Permukaan tembus pandang, dan sinar keluar dari medium yang lebih rapat: dibiaskan menjauhi normal. θ_c adalah sudut kritis.
event-refraction = Permukaan tembus pandang: arah sinar di baliknya mengikuti hukum Snellius.
event-transmission = Arah sinar bias.
event-total-internal-reflection = Tidak ada yang menembus: koefisien k_t ikut sinar ke arah cermin.
event-reflection = Permukaan memantulkan: u dicerminkan pada N.
event-branch-ended-depth = Tingkat { $level } yang terakhir: sinar ini tidak dilacak, dan menyumbang hitam.
event-branch-ended-reflected = Permukaan tidak memantulkan, k_r = 0: tanpa sinar pantul.
event-branch-ended-transmitted = Permukaan tidak tembus pandang, k_t = 0: tanpa sinar bias.
event-attenuated = Cahaya sinar sekunder dilemahkan oleh jarak d ke permukaan ini.
event-branch-added-reflected = Cahaya sinar pantul ditambahkan.
event-branch-added-transmitted = Cahaya sinar bias ditambahkan.
event-reference = Nilai faktor bentuk, dengan integral kontur sampai sepuluh angka: nilai berikut dibandingkan dengannya.
event-form-factor = Faktor bentuk dari patch { $i } ke patch { $j }: bagian cahaya dari patch { $i } yang tiba di patch { $j }. V bernilai 0 bila ada penghalang.
event-faces-away = Kedua bagian saling membelakangi atau sebidang: tidak ada cahaya di antaranya, dan tidak ada yang diintegralkan.
event-pieces = Bagian kedua patch yang saling berhadapan, dengan { $corners_i } dan { $corners_j } sudut, serta luasnya.
event-chosen-area-to-area = Berjauhan dibandingkan radius R: { $points } pasang titik sudah cukup teliti.
event-chosen-element-to-polygon = Terpisah, dan salah satunya kecil: titik-titik patch yang lebih kecil, masing-masing dengan faktor bentuk eksak ke patch yang lebih besar.
event-chosen-contour = Berdekatan atau bersentuhan: integral kontur ganda.
event-points = Satu titik pada tiap patch, di titik Gauss.
event-pair = Pertukaran kedua titik, menurut bobot w: makin dekat dan makin berhadapan, makin besar.
event-element = Satu titik pada patch yang lebih kecil mewakili elemennya, dengan bobot w. Ia melihat patch lain sebagai poligon.
event-polygon-edge = Sisi { $edge } poligon, mulai sudut R_k: dilihat dari x sisi ini membentang sudut |Γ_k|, dan Γ_k tegak lurus padanya.
event-element-seen = Faktor bentuk elemen, eksak untuk titiknya, ditambahkan menurut bobotnya.
event-edge-pair-at-right-angles = Sisi { $edge_i } patch pertama dan sisi { $edge_j } patch kedua saling tegak lurus: tidak menambah apa pun.
event-edge-pair-on-one-line = Sisi { $edge_i } patch pertama dan sisi { $edge_j } patch kedua terletak pada satu garis: I eksak. Panjang dalam satuan rentang L keduanya.
event-edge-pair = Sisi { $edge_i } patch pertama dengan sisi { $edge_j } patch kedua: I eksak sepanjang yang satu, dengan titik Gauss sepanjang yang lain. Panjang dalam satuan rentang L keduanya.
event-ray-met = Sinar mengenai sisi depan patch { $j }, tanpa penghalang: dihitung.
event-ray-missed = Sinar tidak mencapai patch { $j }: jumlah yang mengenai tetap.
event-hemicube = Hemicube berdiri di atas titik x pada patch { $i }: { $resolution } piksel sepanjang rusuk atasnya.
event-hemicube-pixel-top = Piksel ({ $pixel_x }, { $pixel_y }) sisi atas menampilkan patch { $j }: nilainya ΔF.
event-hemicube-pixel-side = Piksel ({ $pixel_x }, { $pixel_y }) sisi tegak { $face } menampilkan patch { $j }: nilainya ΔF, makin kecil makin rendah.
event-hemicube-seen = Faktor bentuk titik ini; rata-rata semua n titik patch { $i } mewakili patch itu.
event-sight-blocked = Ada penghalang antara x dan y: V(x, y) = 0. K adalah pertukaran tanpa penghalang, cos θ_x cos θ_y / (π r^2).
event-sight-free = Tidak ada penghalang antara x dan y: V(x, y) = 1. K adalah pertukarannya, cos θ_x cos θ_y / (π r^2).
event-visible = Dari { $rays } garis pandang: bagian cahaya yang tidak terhalang.
event-form-factor-found-monte-carlo = Faktor bentuk: bagian dari n sinar yang mengenai patch { $j }.
event-form-factor-found-hemicube = Faktor bentuk: rata-rata dari semua hemicube.
event-form-factor-found = Faktor bentuk: pertukaran, menurut bagian yang tidak terhalang, dibagi luas patch { $i }.
event-room = Cahaya ruang dengan { $n } patch akan dicari: satu sistem persamaan untuk tiap kanal warna.
event-room-done = Semua kanal selesai: setiap patch mendapat radiositasnya.
event-channel = Kanal { $channel } dimulai: radiositas bersifat monokrom, jadi tiap kanal diselesaikan sendiri.
event-channel-left-out-like-another = Kanal { $channel } memiliki reflektansi dan emisi yang sama dengan kanal { $like }: solusinya dipakai bersama.
event-channel-left-out-dark = Pada kanal { $channel } tidak ada yang memancar, jadi semua radiositas 0: tidak ada yang perlu diselesaikan.
event-channel-done = Kanal { $channel } selesai.
event-system = { $n } persamaan untuk { $n } radiositas, diselesaikan dengan { $solver }. μ, penguatan baris terbesar, menyatakan paling banyak berapa bagian cahaya yang dipantulkan.
event-started = Patch { $i } sebelum iterasi: radiositasnya, dan bagiannya r_i dari residu.
event-iteration = Iterasi { $k } dimulai.
event-weighted-over-relaxation = Setiap patch melangkah ω kali sejauh yang dikumpulkannya, dengan ω dari Young untuk batas μ.
event-weighted-first = Bobot iterasi Chebyshev yang pertama adalah 1.
event-weighted-chebyshev = Bobot iterasi Chebyshev ini, dari bobot ω′ sebelumnya; pada iterasi kedua ω′ diganti 2.
event-step-lengths = Panjang langkah gradien konjugat: α sepanjang arah p, dan β untuk arah berikutnya.
event-gathering = Patch { $i } mengumpulkan cahaya dari semua patch lain: ia memancarkan E_i sendiri dan memantulkan bagian ρ_i dari yang tiba.
event-exchanged = Dari cahaya yang dikumpulkan patch { $i }, patch { $j } menyumbang faktor bentuk kali radiositas.
event-gathered-relaxed = Patch { $i } selesai mengumpulkan, dan melangkah ω kali sejauh dari radiositas lama ke hasil pengumpulan.
event-gathered = Patch { $i } selesai mengumpulkan: radiositas barunya adalah yang dipancarkan ditambah yang dipantulkan.
event-ambient-radiosity = Radiositas ambien: nilai rata-rata yang akan dicapai cahaya yang belum ditembakkan, andai ruang terang merata. ⟨…⟩ rata-rata menurut luas.
event-overshooting = Patch { $i } menembak lebih: radiositas ΔB_i yang belum ditembakkan, dan ambien di muka. ΔB_i A_i dengan ambien terbesar di antara semua.
event-shooting = Patch { $i } menembakkan radiositas ΔB_i yang belum ditembakkan ke semua patch lain: ΔB_i A_i terbesar di antara semua.
event-received = Patch { $j } menerima, dan memantulkan bagian ρ_j: itu cahaya yang belum ditembakkannya. F_j_i diperoleh dari baris patch { $i } melalui resiprositas.
event-shot-done = Tembakan patch { $i } selesai: yang ditembakkannya kini termasuk radiositasnya.
event-updated-chebyshev = Patch { $i }, diubah bersama semua patch lain: B″ radiositasnya satu iterasi sebelumnya, r residunya.
event-updated-direct = Patch { $i }: d menyelesaikan sistem untuk residu, dengan eliminasi.
event-updated-along-direction = Patch { $i }, diubah bersama semua patch lain, sepanjang arah p.
event-iteration-done = Iterasi selesai: seberapa besar residu dibandingkan emisi. ε_B membatasi galat setiap radiositas, bila batasnya diketahui.
event-converged = Konvergen setelah { $iterations } iterasi: residunya cukup kecil.
event-not-converged = Tidak konvergen setelah { $iterations } iterasi: ini bukan solusi.

## what a scope is called

scope-frame = gambar
scope-polygon = poligon
scope-illumination = pencahayaan
scope-light = cahaya
scope-edge-table = tabel sisi
scope-scan-line = garis scan
scope-edge = sisi
scope-span = bentang
scope-pixel = piksel
scope-vertex = titik sudut
scope-triangle = segitiga
scope-search = pencarian
scope-ray = sinar
scope-shadow-ray = sinar bayangan
scope-form-factor = faktor bentuk
scope-element = elemen
scope-hemicube = hemicube
scope-enclosure = ruang
scope-channel = kanal
scope-system = sistem
scope-iteration = iterasi
scope-patch = patch

## notes beside formulas

note-as-on-the-slide = Seperti pada slide, sebagai ganti f_{"{"}att{"}"} · (N·L); nilainya membesar dengan jarak:
note-incremental = Secara inkremental: nilai sebelumnya ditambah langkah tetap. Selisihnya dengan nilai langsung:
note-approximate = jarak deret dari kosinus normal satuan

## pseudocode

for-each-polygon = untuk setiap poligon
for-each-vertex-v-without-a-normal = untuk setiap titik sudut v tanpa normal
build-the-edge-table = susun tabel sisi
for-each-scan-line-y = untuk setiap garis scan y
for-each-active-edge = untuk setiap sisi aktif
interpolate = interpolasi
for-each-span-from-x-4-to-x-5 = untuk setiap bentang dari x_4 sampai x_5
for-each-pixel-x-p = untuk setiap piksel x_P
if-nearer-than-the-depth-buffer = jika lebih dekat daripada buffer kedalaman
the-point-of-the-polygon-that-the-pixel-shows = titik poligon yang ditampilkan piksel
the-true-surface-behind-p = permukaan sebenarnya di balik P
without-one = bila tidak ada
for-each-vertex-v-not-yet-met = untuk setiap titik sudut v yang belum ditemui
for-each-triangle-of-it-about-its-middle = untuk setiap segitiganya, di sekitar pusatnya
toward-the-eye = ke arah mata
turn-n-toward-v = balikkan N ke arah V
for-each-light = untuk setiap cahaya
toward-the-light = ke arah cahaya
or = atau
taylor-series-of-each-cosine-c = deret Taylor tiap kosinus c
where-y-cuts-the-edge = tempat y memotong sisi
at-the-first-pixel-of-the-span = di piksel pertama bentang:
then-pixel-by-pixel = lalu, piksel demi piksel:
mean-of-the-vertices = rata-rata titik sudut
for-each-gauss-point-x-of-i-with-weight-w-x = untuk setiap titik Gauss x dari i, dengan bobot w_x
for-each-gauss-point-y-of-j-with-weight-w-y = untuk setiap titik Gauss y dari j, dengan bobot w_y
clip-each-to-the-front-of-the-other = potong i ke sisi depan j, dan j ke sisi depan i
for-each-edge-of-i-with-direction-e = untuk setiap sisi i, dengan arah e
for-each-edge-of-j-with-direction-f = untuk setiap sisi j, dengan arah f
exact-along-s-else-by-gauss-points = eksak sepanjang s;  eksak sepanjang t bila segaris, jika tidak dengan titik Gauss
for-each-gauss-point-x-of-i-with-weight-w = untuk setiap titik Gauss x dari i, dengan bobot w
for-each-edge-of-j-seen-from-x = untuk setiap sisi R_k, R_k+1 dari j dilihat dari x
angle-between-r-k-and-the-next = sudut antara R_k dan R_k+1, searah R_k × R_k+1
for-each-piece-of-i-and-of-j = untuk setiap bagian i dan j
clip-both-to-the-front-of-the-other-nothing-left-0 = potong keduanya ke sisi depan lawannya;  bila habis: 0
exchange-of-the-two = pertukaran keduanya
share-that-nothing-blocks = bagian yang tidak terhalang
return = kembalikan
for-each-of-n-by-n-points-x-of-i = untuk setiap dari n × n titik x pada i
draw-what-stands-in-the-way-onto-the-five-faces = gambar penghalang ke kelima muka, simpan yang terdekat
for-each-pixel-u-v-whose-centre-j-covers-nearest-of-all = untuk setiap piksel (u, v) yang pusatnya ditutupi j, terdekat dari semua
on-top = di sisi atas
at-the-sides = di sisi tegak
for-each-of-n-points-s-t-u-v-of-a-sobol-sequence = untuk setiap dari n titik (s, t, u, v) barisan Sobol
the-point-of-i-at-s-t = titik i di (s, t)
direction = arah
across-n-i = tegak lurus N_i
along-it = searahnya
if-the-ray-meets-the-front-of-j-and-nothing-before = jika sinar mengenai sisi depan j, tanpa penghalang:
if-nothing-can-stand-between-return-1 = jika tidak ada kelompok patch yang dapat menghalangi i dan j: kembalikan 1
point-of-i-at-s-t = titik i di (s, t)
point-of-j-at-u-v = titik j di (u, v)
whether-the-ray-from-x-to-y-meets-a-surface = apakah sinar dari x ke y mengenai permukaan
over-what-is-not-blocked = atas yang tidak terhalang
for-each-vertex-v-not-yet-lit = untuk setiap titik sudut v yang belum diberi pencahayaan
for = untuk
until = sampai
then = lalu
solve = selesaikan
for-each-patch-i = untuk setiap patch i
for-each-patch-j = untuk setiap patch j
the-patch-of-largest = patch dengan nilai terbesar
what-it-received = yang diterimanya
means-by-area = rata-rata menurut luas
for-each-pixel-in-the-projection-plane = untuk setiap piksel pada bidang proyeksi
ray-from-the-reference-point-through-the-pixel = sinar dari titik acuan melalui piksel
none = kosong
for-every-object-in-the-scene = untuk setiap objek dalam adegan
if-the-ray-meets-it-nearer = jika sinar mengenainya dan t < NearestT
object = objek
if-nothing-is-met = jika NearestObject kosong
background = latar belakang
otherwise = selain itu
emission = emisi
if-nothing-is-met-return-background = jika NearestObject kosong: kembalikan latar belakang
shoot-a-ray-to-the-light-in-shadow-or-not = tembakkan sinar ke cahaya: dalam bayangan atau tidak
ambient-and-light-that-arrives-and-emission = ambien + cahaya yang sampai + emisi
if-the-surface-is-reflective = jika permukaan memantulkan
if-it-is-transparent = jika tembus pandang
the-chart-of-the-object-at-p = peta objek di P
colour-of-the-texture-at-u-v = warna tekstur di (u, v)
and-so = sehingga
for-each-edge-not-yet-drawn = untuk setiap sisi yang belum digambar
clip-the-edge-to-what-the-eye-sees = potong sisi ke yang dilihat mata
rounded-up = dibulatkan ke atas
plot-the-pixel-at-x-y = gambar piksel di (x, y)
far-area-to-area = berjauhan, keduanya kecil:  areaToArea
apart-element-to-polygon = terpisah, i kecil:          elementToPolygon
near-or-touching-contour = dekat atau bersentuhan:     contour
code-at-line = Kode semu, pada baris: { $line }

## what kinds of events are called

kind-frame = Gambar
kind-polygon = Poligon
kind-polygon-done = Poligon selesai
kind-frame-done = Gambar selesai
kind-face-normal-added = Normal muka ditambahkan
kind-vertex-normal = Normal titik sudut
kind-file-normal = Normal dari berkas
kind-normal-vanished = Normal lenyap
kind-illumination = Pencahayaan
kind-viewer = Pengamat
kind-ambient = Ambien
kind-light = Cahaya
kind-to-light = Ke arah cahaya
kind-diffuse = Difus
kind-mirrored = Dicerminkan
kind-halfway = Arah tengah
kind-specular = Spekular
kind-light-added = Cahaya ditambahkan
kind-illuminated = Selesai dihitung
kind-edge-table = Tabel sisi
kind-corner-placed = Sudut ditempatkan
kind-edge-entered = Sisi dimasukkan
kind-edge-skipped = Sisi dilewati
kind-edge-table-built = Tabel sisi selesai
kind-scan-line = Garis scan
kind-edge = Sisi
kind-edge-ends = Ujung sisi
kind-edge-interpolated = Sisi diinterpolasi
kind-edge-cut = Sisi dipotong
kind-span = Bentang
kind-span-ends = Ujung bentang
kind-pixel = Piksel
kind-depth-tested = Kedalaman diuji
kind-span-interpolated = Bentang diinterpolasi
kind-pixel-colored = Piksel diwarnai
kind-pixel-hidden = Piksel tersembunyi
kind-span-done = Bentang selesai
kind-scan-line-done = Garis scan selesai
kind-middle = Titik tengah
kind-vertex = Titik sudut
kind-vertex-lit = Intensitas titik sudut
kind-vertex-ready = Normal titik sudut siap
kind-pixel-point = Titik piksel
kind-pixel-normal = Normal piksel
kind-pixel-normal-lost = Normal piksel hilang
kind-true-point = Titik sebenarnya
kind-textured = Tekstur di titik
kind-textured-linearly = Tekstur secara linear
kind-texture-taken = Tekstur dipilih
kind-texture-applied = Tekstur diterapkan
kind-triangle = Segitiga
kind-normal-at-middle = Normal di pusat
kind-normal-slopes = Kemiringan normal
kind-series = Deret
kind-light-expanded = Cahaya diuraikan
kind-expanded = Penguraian selesai
kind-differences-started = Selisih dimulai
kind-cosine-evaluated = Kosinus dihitung
kind-light-summed = Cahaya dijumlahkan
kind-triangle-done = Segitiga selesai
kind-edge-clipped = Sisi dipangkas
kind-edge-unseen = Sisi tak terlihat
kind-step-chosen = Langkah dipilih
kind-pixel-plotted = Piksel digambar
kind-edge-done = Sisi selesai
kind-through = Melalui titik
kind-search = Pencarian
kind-object-tested = Objek diuji
kind-light-tested = Cahaya diuji
kind-found = Ditemukan
kind-between-tested = Penghalang diuji
kind-unshadowing = Tanpa bayangan
kind-background = Latar belakang
kind-light-met = Cahaya dikenai
kind-surface-met = Permukaan dikenai
kind-faced = Normal dihadapkan
kind-ray = Sinar
kind-local = Suku lokal
kind-returned = Dikembalikan
kind-shadow-ray = Sinar bayangan
kind-shadow = Bayangan
kind-refraction = Pembiasan
kind-transmission = Transmisi
kind-total-internal-reflection = Pemantulan internal total
kind-reflection = Pemantulan
kind-branch-ended = Cabang berakhir
kind-attenuated = Dilemahkan
kind-branch-added = Cabang ditambahkan
kind-reference = Acuan
kind-form-factor = Faktor bentuk
kind-faces-away = Membelakangi
kind-pieces = Bagian
kind-chosen = Cara dipilih
kind-points = Titik-titik
kind-pair = Pasangan
kind-element = Elemen
kind-element-seen = Elemen ditambahkan
kind-edge-pair = Pasangan sisi
kind-hemicube = Hemicube
kind-hemicube-seen = Hemicube ditambahkan
kind-sight = Garis pandang
kind-visible = Bagian yang terlihat
kind-form-factor-found = Faktor bentuk ditemukan
kind-room = Ruang
kind-room-done = Ruang selesai
kind-channel = Kanal
kind-channel-left-out = Kanal dilewati
kind-channel-done = Kanal selesai
kind-system = Sistem
kind-started = Nilai awal
kind-iteration = Iterasi
kind-weighted = Bobot
kind-step-lengths = Panjang langkah
kind-gathering = Mengumpulkan
kind-exchanged = Pertukaran
kind-gathered = Selesai mengumpulkan
kind-shooting = Menembakkan
kind-received = Menerima
kind-shot-done = Tembakan selesai
kind-updated = Diperbarui
kind-iteration-done = Iterasi selesai
kind-converged = Konvergen
kind-not-converged = Tidak konvergen

## values that are words

value-red = merah
value-green = hijau
value-blue = biru
value-jacobi = iterasi Jacobi
value-gauss-seidel = iterasi Gauss–Seidel
value-over-relaxation = relaksasi lebih berturut-turut
value-shooting = penembakan
value-overshooting = penembakan lebih
value-chebyshev = iterasi Chebyshev
value-conjugate-gradients = gradien konjugat
value-direct = eliminasi
value-primary = primer
value-reflected = pantul
value-transmitted = bias
value-total-internal-reflection = pemantulan internal total
value-depth = kedalaman
value-no-coefficient = tanpa koefisien
value-nothing-emits = tidak ada yang memancar
value-equal-channel = kanal yang sama
value-at-right-angles = saling tegak lurus
value-on-one-line = segaris
value-by-gauss-points = dengan titik Gauss
value-auto = otomatis
value-area-to-area = luas ke luas
value-element-to-polygon = elemen ke poligon
value-contour = kontur
value-monte-carlo = Monte Carlo
value-hemicube = hemicube
value-nothing = tidak ada
value-light = cahaya
value-object = objek
value-unknown = tidak diketahui
value-n-dot-l = N·L
value-n-dot-h = N·H
value-r-dot-v = R·V

## quantities whose symbol is a word

quantity-width = lebar
quantity-height = tinggi
quantity-object = objek
quantity-polygon = poligon
quantity-face = muka
quantity-faces = jumlah muka
quantity-length = panjang
quantity-turned = dibalik
quantity-light = cahaya
quantity-slide-factor = faktor slide
quantity-corners = jumlah sudut
quantity-corner = sudut
quantity-edge = sisi
quantity-upper = atas
quantity-lower = bawah
quantity-first = pertama
quantity-end = akhir
quantity-from = dari
quantity-to = ke
quantity-edges = jumlah sisi
quantity-i-4-incremental = I_4 inkremental
quantity-n-4-incremental = N_4 inkremental
quantity-difference = selisih
quantity-nearest = terdekat
quantity-nearer = lebih dekat
quantity-i-p-incremental = I_P inkremental
quantity-n-p-incremental = N_P inkremental
quantity-color = warna
quantity-texture = tekstur
quantity-texture-linear = tekstur linear
quantity-linear = linear
quantity-vertex = titik sudut
quantity-vanished = lenyap
quantity-cosine = kosinus
quantity-error = galat
quantity-power = pangkat
quantity-samples = sampel
quantity-objects = jumlah objek
quantity-met = dikenai
quantity-blocks = menghalangi
quantity-entering = masuk
quantity-emission = emisi
quantity-ray = sinar
quantity-level = tingkat
quantity-blocked = terhalang
quantity-blocker = penghalang
quantity-branch = cabang
quantity-why = sebab
quantity-divisor = pembagi
quantity-carried = dibawa
quantity-method = metode
quantity-corners-i = sudut i
quantity-corners-j = sudut j
quantity-area-i = luas i
quantity-area-j = luas j
quantity-chosen = dipilih
quantity-distance = jarak
quantity-radius-i = radius i
quantity-radius-j = radius j
quantity-points = titik
quantity-term = suku
quantity-sum = jumlah
quantity-edge-i = sisi i
quantity-edge-j = sisi j
quantity-way = cara
quantity-direction = arah
quantity-hits = mengenai
quantity-resolution = resolusi
quantity-pixel-x = piksel x
quantity-pixel-y = piksel y
quantity-share = bagian
quantity-rays = jumlah sinar
quantity-channel = kanal
quantity-like = seperti
quantity-solver = penyelesai
quantity-gain = penguatan
quantity-unshot-i = belum ditembakkan i
quantity-product = hasil kali
quantity-ambient = ambien
quantity-shot = ditembakkan
quantity-unshot-j = belum ditembakkan j
quantity-residual = residu
quantity-error-bound = batas galat
quantity-iterations = iterasi

## panels

names-point-light = cahaya titik
names-directional-light = cahaya terarah
names-light = cahaya { $number }
names-numbered = { $kind } { $number }
names-background = latar belakang
names-ray-meets = { $ray } → { $thing }
inspector-step = langkah { $step }
inspector-step-and-depth = langkah { $step } · kedalaman { $depth }
inspector-this-step = langkah ini
inspector-more = … { $count } lagi
inspector-no-values = Langkah ini tidak memuat nilai.
time-line-at-step = Garis waktu pada langkah { $step } dari { $steps }

## what the size of a setting counts, and what errors are errors of

measure-longitudes-of-a-sphere = garis bujur sebuah bola
measure-steps = langkah
measure-levels = tingkat
measure-rays-along-a-pixel-s-side = sinar sepanjang sisi piksel
measure-objects = objek
measure-distance-in-radii = jarak, dalam jari-jari
measure-samples = sampel
measure-sweeps = sapuan
measure-patches-along-a-wall = patch sepanjang dinding
measure-pixels = piksel
measure-triangles = segitiga
measure-patches = patch
measure-events = kejadian
measure-intensity = intensitas
measure-intensity-toward-the-viewer = intensitas di mana N·V ≥ 0,6
measure-the-values-from-0-to-1 = nilai dari 0 sampai 1
measure-t-a-share-of-the-distance = t, sebagai bagian dari jarak
measure-radiosity-in-the-unit-of-the-emission = B, dalam satuan emisi
measure-radiosity-at-the-finest-centres = B, di pusat patch terhalus
measure-form-factor = F
measure-nothing = tidak ada

## studies

study-patches = Radiositas menurut jumlah patch per dinding
study-patches-about = Seberapa halus dinding harus dibagi, dan seberapa teliti faktor bentuk untuk itu?
study-solvers = Penyelesai sistem radiositas
study-solvers-about = Penyelesai mana yang lebih dahulu mencapai galat B tertentu? Satu sapuan adalah satu iterasi, atau tembakan sebanyak jumlah patch.
study-ray-samples = Metode sinar menurut jumlah sampel per piksel
study-ray-samples-about = Berapa sinar per piksel cukup untuk melawan tepi bergerigi?
study-interpolation = Interpolasi inkremental lawan langsung
study-interpolation-about = Satu penjumlahan tiap langkah, atau rumusnya dihitung ulang: apa yang dihemat penjumlahan, dan apa yang hilang?
study-shading = Metode peneduhan menurut kehalusan poligon
study-shading-about = Berapa banyak poligon yang diperlukan tiap metode peneduhan, dan berapa lama, sampai bola tampak sehalus aslinya?
study-search = Semua objek satu per satu lawan hierarki
study-search-about = Mulai berapa objek hierarki menguntungkan? Keduanya menemukan hal yang sama, jadi tidak ada galat.
study-precision = f32 lawan f64: titik temu pada bola satuan yang jauh
study-precision-about = Apakah rumus lebih menentukan daripada presisi? Sinar datang ke bola satuan dari tempat yang makin jauh.
study-form-factors = Metode faktor bentuk menurut jumlah sampel
study-form-factors-about = Cara mana yang termurah untuk galat tertentu, bila patch berhadapan, dan bila bersentuhan? Untuk metode adaptif, 1/toleransi dihitung sebagai sampel.
study-growth = Bagaimana kerja bertambah
study-growth-about = Berapa biaya dua kali lipat piksel, segitiga, tingkat, patch, atau kejadian?
study-ray-depth = Ray tracing menurut kedalaman
study-ray-depth-about = Seberapa dalam sinar harus diikuti, dan berapa biaya tiap tingkat? Sinar tidak dipotong secara adaptif: `path_attenuation` mengubah gambarnya, sehingga pemotongan menurut kedalaman lebih cepat tidak merugikan.

## parts of studies

part-path-attenuation = pelemahan di jalan [{ $value }]
part-all-form-factors = Semua faktor bentuk adegan, tanpa penghalang
part-pixels = piksel
part-triangles = segitiga sebuah bola, dalam 160×120 piksel
part-depth-of-rays = kedalaman sinar
part-form-factors-of-a-cube = faktor bentuk semua patch sebuah kubus
part-solving-a-cube = penyelesaian sebuah kubus sampai residu 1e-6
part-events = kejadian sebuah gambar Gouraud
part-steps = Langkah
part-walls = Dinding dengan n×n patch
part-distances = Jarak
part-method = { $value }
part-objects = Objek
part-spheres = Bola sebagai poligon
part-one-channel = Satu kanal; satu sapuan adalah satu iterasi, atau tembakan sebanyak jumlah patch
part-squares-at-distance-1 = Persegi sejajar pada jarak 1
part-squares-at-distance-0-1 = Persegi sejajar pada jarak 0,1
part-squares-with-a-common-edge = Persegi dengan sisi bersama pada 90°

## plots of studies

study-time = waktu satu kali jalan (median)
study-rms-error = galat rms dari { $quantity }
study-own-error = galat acuan itu sendiri
study-no-result = Tidak ada pengaturan yang memberi hasil.
