# Four surfaces by ray casting
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' pictures.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,348 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,9.20cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'pictures.'.format
data = 'pictures.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 92 mm

# first root, certified / torus
set label 'first root, certified' at screen 0.01149,0.73098 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front
set label 'torus' at screen 0.14799,0.96957 center font ',8' tc rgb '#202020' noenhanced front
set label '7,540 hits, every ray proved' at screen 0.14799,0.49457 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.03448; set rmargin at screen 0.26149
set bmargin at screen 0.51630; set tmargin at screen 0.94565
unset border; unset xtics; unset ytics
set xrange [-0.5:179.5]; set yrange [-0.5:179.5]
plot data matrix index 0 using 1:2:($3==0 ? 255 : $3==256 ? 213 : $3==257 ? 0 : $3):($3==0 ? 255 : $3==256 ? 94 : $3==257 ? 114 : $3):($3==0 ? 255 : $3==256 ? 0 : $3==257 ? 178 : $3) with rgbimage
unset label; unset arrow

# first root, certified / chmutov-sextic
set label 'chmutov-sextic' at screen 0.39224,0.96957 center font ',8' tc rgb '#202020' noenhanced front
set label '16,447 hits, every ray proved' at screen 0.39224,0.49457 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.27874; set rmargin at screen 0.50575
set bmargin at screen 0.51630; set tmargin at screen 0.94565
unset border; unset xtics; unset ytics
set xrange [-0.5:179.5]; set yrange [-0.5:179.5]
plot data matrix index 1 using 1:2:($3==0 ? 255 : $3==256 ? 213 : $3==257 ? 0 : $3):($3==0 ? 255 : $3==256 ? 94 : $3==257 ? 114 : $3):($3==0 ? 255 : $3==256 ? 0 : $3==257 ? 178 : $3) with rgbimage
unset label; unset arrow

# first root, certified / steiner
set label 'steiner' at screen 0.63649,0.96957 center font ',8' tc rgb '#202020' noenhanced front
set label '3,581 hits, every ray proved' at screen 0.63649,0.49457 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.52299; set rmargin at screen 0.75000
set bmargin at screen 0.51630; set tmargin at screen 0.94565
unset border; unset xtics; unset ytics
set xrange [-0.5:179.5]; set yrange [-0.5:179.5]
plot data matrix index 2 using 1:2:($3==0 ? 255 : $3==256 ? 213 : $3==257 ? 0 : $3):($3==0 ? 255 : $3==256 ? 94 : $3==257 ? 114 : $3):($3==0 ? 255 : $3==256 ? 0 : $3==257 ? 178 : $3) with rgbimage
unset label; unset arrow

# first root, certified / thin-disc
set label 'thin-disc' at screen 0.88075,0.96957 center font ',8' tc rgb '#202020' noenhanced front
set label '4,446 hits, every ray proved' at screen 0.88075,0.49457 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.76724; set rmargin at screen 0.99425
set bmargin at screen 0.51630; set tmargin at screen 0.94565
unset border; unset xtics; unset ytics
set xrange [-0.5:179.5]; set yrange [-0.5:179.5]
plot data matrix index 3 using 1:2:($3==0 ? 255 : $3==256 ? 213 : $3==257 ? 0 : $3):($3==0 ? 255 : $3==256 ? 94 : $3==257 ? 114 : $3):($3==0 ? 255 : $3==256 ? 0 : $3==257 ? 178 : $3) with rgbimage
unset label; unset arrow

# marching, 50 steps / torus
set label 'marching, 50 steps' at screen 0.01149,0.25815 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front
set label '3 missed, 1 late' at screen 0.14799,0.02174 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.03448; set rmargin at screen 0.26149
set bmargin at screen 0.04348; set tmargin at screen 0.47283
unset border; unset xtics; unset ytics
set xrange [-0.5:179.5]; set yrange [-0.5:179.5]
plot data matrix index 4 using 1:2:($3==0 ? 255 : $3==256 ? 213 : $3==257 ? 0 : $3):($3==0 ? 255 : $3==256 ? 94 : $3==257 ? 114 : $3):($3==0 ? 255 : $3==256 ? 0 : $3==257 ? 178 : $3) with rgbimage
unset label; unset arrow

# marching, 50 steps / chmutov-sextic
set label '60 missed, 57 late' at screen 0.39224,0.02174 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.27874; set rmargin at screen 0.50575
set bmargin at screen 0.04348; set tmargin at screen 0.47283
unset border; unset xtics; unset ytics
set xrange [-0.5:179.5]; set yrange [-0.5:179.5]
plot data matrix index 5 using 1:2:($3==0 ? 255 : $3==256 ? 213 : $3==257 ? 0 : $3):($3==0 ? 255 : $3==256 ? 94 : $3==257 ? 114 : $3):($3==0 ? 255 : $3==256 ? 0 : $3==257 ? 178 : $3) with rgbimage
unset label; unset arrow

# marching, 50 steps / steiner
set label '315 missed, 84 late' at screen 0.63649,0.02174 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.52299; set rmargin at screen 0.75000
set bmargin at screen 0.04348; set tmargin at screen 0.47283
unset border; unset xtics; unset ytics
set xrange [-0.5:179.5]; set yrange [-0.5:179.5]
plot data matrix index 6 using 1:2:($3==0 ? 255 : $3==256 ? 213 : $3==257 ? 0 : $3):($3==0 ? 255 : $3==256 ? 94 : $3==257 ? 114 : $3):($3==0 ? 255 : $3==256 ? 0 : $3==257 ? 178 : $3) with rgbimage
unset label; unset arrow

# marching, 50 steps / thin-disc
set label '3,289 missed, 0 late' at screen 0.88075,0.02174 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.76724; set rmargin at screen 0.99425
set bmargin at screen 0.04348; set tmargin at screen 0.47283
unset border; unset xtics; unset ytics
set xrange [-0.5:179.5]; set yrange [-0.5:179.5]
plot data matrix index 7 using 1:2:($3==0 ? 255 : $3==256 ? 213 : $3==257 ? 0 : $3):($3==0 ? 255 : $3==256 ? 94 : $3==257 ? 114 : $3):($3==0 ? 255 : $3==256 ? 0 : $3==257 ? 178 : $3) with rgbimage
unset label; unset arrow
unset multiplot
unset output
