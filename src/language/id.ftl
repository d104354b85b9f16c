### Semua teks program dalam bahasa Indonesia. Kunci menamai pesannya di setiap katalog; argumennya sama di semua katalog.

## focus

focus-frame = seluruh gambar
focus-polygon = poligon { $number }
focus-line = garis scan { $number }
focus-pixel = piksel ({ $x }, { $y })
focus-iterations = iterasi { $first }–{ $last }
focus-patch = patch { $number }

## common

common-patches = patch
common-error = galat
common-of = dari
common-matrix-of-form-factors = Matriks faktor bentuk
common-light = cahaya
common-eye = mata
common-rays = sinar
common-relative-residual = residu relatif
common-in-hand = Sekarang:
common-total-internal-reflection = pemantulan internal total
common-level = tingkat

## app

app-present = Presentasi
app-share = Bagikan langkah
app-shared = Disalin: perintah yang membuka pelajaran ini pada langkah ini.
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
app-measuring = mengukur
app-called-off = Dibatalkan; yang sudah masuk tetap ada.
app-no-findings = Tidak ada hasil:
app-nothing-measured = Pilih sebuah studi lalu ukur. Studi berjalan di latar belakang, pada satu utas.
app-debug-build = Ini build debug: waktunya tidak mengatakan apa-apa tentang algoritme.
app-study-plot = grafik studi
app-time-of-a-run = waktu satu kali jalan (median)
app-rms-error-of = galat rms dari
app-on-the-front = Di front Pareto: tidak ada pengaturan lain yang secepat dan seteliti ini.
app-time-is = waktu
app-quartiles = kuartil
app-memory-is = memori
app-no-law = tidak ada hukum yang jelas
app-click-opens-it = Klik membuka gambar dan jalannya.
app-measured-again-by = Tidak menghasilkan gambar. Diukur lagi, dengan baris tersendiri di tabel, oleh
app-reference = Acuan
app-pareto = Berlingkar, pada garis abu-abu: front Pareto. Batang: kuartil.
app-text-size = Ukuran teks
app-one-back = satu kejadian mundur
app-one-on = satu kejadian maju
app-step = langkah
app-steps-a-second = langkah/dtk
app-loop = ulang
app-loop-off = tanpa ulang
app-loop-from-here = dari langkah ini
app-loop-to-here = sampai langkah ini
app-run-to = lompat ke
app-next-of-this-kind = berikutnya yang sejenis
app-search = cari
app-search-hint = EdgeInterpolated y=15
app-breakpoint = titik henti
app-truncated = Hanya awal dari proses ini yang muat di memori; gambarnya tetap utuh.
app-making-the-picture = seluruh gambar:
app-unsaid = Dengan nilai-nilai ini, sebagian dari yang dijelaskan pelajaran ini tidak terjadi.
app-put-back = Mulai lagi dengan nilai-nilai pelajaran
app-slide = Seperti pada slide
app-last-said = Sebelumnya, pada langkah
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
app-show-the-step = tunjukkan langkahnya
app-image = Gambar
app-scan-line = Garis scan
app-active-edges = Sisi aktif
app-vertex = Titik sudut
app-left-out = Ditinggalkan: tidak diperlukan di sini
app-left-out-about = Adegan ini tidak memerlukannya, maka tidak dikerjakan. Centang satu baris agar tetap dikerjakan: tidak ada yang berubah selain langkah dan waktunya.
app-nothing-left-out = Tidak ada: cara menggambar adegan ini memerlukan semua yang dikerjakannya.
app-is-needed = Itu diperlukan di sini, atau bukan bagian metode ini.
app-times-measured = mengukur …
app-times-none = terlalu lama untuk diukur di sini; `lightwalk needs` mengukurnya
app-time-without = ditinggalkan:
app-time-with = tetap dikerjakan:
app-time-tie = tidak ada beda di luar derau
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
app-as-a-number = sebagai angka
app-distance = jarak
app-from-the-target = dari yang dilihat kamera
app-divisions = pembagian
app-line = garis
app-polygon = poligon
app-pixel = piksel
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
app-not-a-number = Itu bukan angka; tulis misalnya 0.52.
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

## active-edges

active-edges-no-edges = Pada langkah ini tidak ada tabel sisi: setiap poligon membuat tabelnya sendiri. Di sana setiap sisi mendapat satu baris, dan sisi aktif ditonjolkan.
active-edges-no-table = Rangka kawat tidak memerlukan tabel sisi: sisinya digambar satu per satu. Buka pelajaran datar atau Gouraud.
active-edges-edge = sisi
active-edges-from = y dari
active-edges-to = y sampai
active-edges-a-line = baris
active-edges-waits = menunggu
active-edges-done = selesai
active-edges-more = lagi

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
app-skipped-plane = bidang tak terhingga tidak punya poligon
app-skipped-objects = objek
app-skipped-pairs = pasang patch

## comparison

comparison-illuminated = dihitung
comparison-interpolated = interpolasi
comparison-roots = akar
comparison-series = dari deret
comparison-a-pixel = per piksel

## convergence

convergence-bound = batas galat B
convergence-iteration = iterasi k
convergence-none-yet = Belum ada iterasi yang selesai.

## difference

difference-against = luminans dikurangi luminans
difference-rms = rms
difference-largest = maks
difference-here = di sini

## form-factor

form-factor-no-pair = Proses ini mencari cahaya semua patch. Pilih satu faktor bentuk untuk melihat cara mencarinya.
form-factor-exact = acuan
form-factor-hits = mengenai j
form-factor-free = tak terhalang

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

image-only = fokus:
image-drawn = piksel yang sudah digambar:

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
matrix-gathers = mengumpulkan baris
matrix-shoots = menembakkan kolom
matrix-sum = jumlah baris

## panels

panels-no-steps = Tidak ada yang direkam di sini: tidak ada poligon dalam fokus. Klik gambar untuk melihat tempat lain.
panels-no-polygons = Metode ini mengikuti sinar dan tidak mengolah poligon. Lihatlah pohon sinar.
panels-no-rays = Metode ini mengolah poligon dan tidak mengikuti sinar. Buka pelajaran tentang ray casting atau ray tracing.
panels-no-patches = Proses ini tidak mempertukarkan cahaya antar-patch. Buka pelajaran tentang radiositas.
panels-not-compared = Gambar-gambar yang dibandingkan sedang dibuat, atau pelajaran ini tidak membandingkan apa pun.
panels-step = Langkah
panels-yes = ya
panels-no = tidak

## profile

profile-intensity = intensitas
profile-slope = kemiringannya, per piksel (lompatan nilai dipotong)
profile-seen = seperti terlihat (inhibisi lateral)
profile-line = garis scan
profile-largest-jump = lompatan kemiringan terbesar

## race

race-iterations = iterasi (n tembakan dihitung satu)
race-time = detik
race-error = galat relatif B
race-running = Para penyelesai masih berjalan.
race-no-solution = Ruangan ini tidak punya solusi, jadi tidak ada pemenang.
race-not-begun = Para penyelesai menunggu di garis mulai. Melangkahlah sampai akhir sebuah iterasi.
race-gave-up = menyerah
race-on-the-way = di jalan

## radiosity

radiosity-radiosity = radiositas B
radiosity-with-unshot = radiositas B + belum ditembakkan
radiosity-unshot = radiositas belum ditembakkan
radiosity-emission = emisi E
radiosity-reflectance = reflektansi ρ
radiosity-patches = Patch ruangan:
radiosity-seen = terlihat dari depan, menembus punggung patch yang membelakangi:
radiosity-no-room = Adegan ini tidak dapat dibagi menjadi patch: ada permukaan tanpa batas, tanpa luas, atau jumlahnya terlalu banyak.
radiosity-red = merah
radiosity-green = hijau
radiosity-blue = biru

## ray-tree

ray-tree-no-ray = Begitu sebuah sinar dikirim lewat piksel, panel ini menggambar pohon semua sinar pembentuk warnanya. Pada langkah ini belum ada: lanjutkan.
ray-tree-no-rays = Metode ini mengolah poligon dan tidak mengikuti sinar. Buka pelajaran ray casting atau ray tracing untuk melihat pohon sinar sebuah piksel.
ray-tree-inside = di dalam
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
ray-tree-ray = sinar
ray-tree-hidden = tak tampak
ray-tree-shadow-rays = Sinar bayangan di
ray-tree-lights = Cahaya di
ray-tree-coming-back = Kembali ke atas
ray-tree-blocked = terhalang
ray-tree-blocked-by = terhalang
ray-tree-clear = bebas
ray-tree-so-far = sejauh ini
ray-tree-nearest = terdekat
ray-tree-tested = diuji
ray-tree-missed = meleset

## rays

rays-side = dari samping
rays-above = dari atas
rays-rays = Sinar piksel sejauh ini:
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
vectors-angles = sudut dengan N
vectors-blocked = terhalang oleh
vectors-arrives = sampai
vectors-away = di balik permukaan
vectors-leans = keluar bidang
vectors-critical = kritis
vectors-no-t = tanpa T
vectors-air = udara

## vertex

vertex-nothing = Saat sebuah titik diberi pencahayaan, panel ini menampilkan normal, vektor ke sumber cahaya dan mata, serta suku intensitasnya. Pada langkah ini tidak ada.
vertex-wireframe = Rangka kawat tidak diberi pencahayaan: hanya sisi yang digambar. Buka pelajaran datar atau Gouraud.
