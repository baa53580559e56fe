# Sketches in the plane with the parameters of their constraints
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' sketches.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,296 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,7.84cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'sketches.'.format
data = 'sketches.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 78 mm
set label 'apollonius' at screen 0.16475,0.96174 center font ',8' tc rgb '#202020' noenhanced front
set label 'circles-of-a-triangle' at screen 0.50000,0.96174 center font ',8' tc rgb '#202020' noenhanced front
set label 'articulation-pair' at screen 0.83525,0.96174 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.16475,0.00893 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.05846,0.19179 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.27104,0.19179 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.13907,0.73902 center font ',7' tc rgb '#202020' noenhanced front
set label 'a' at screen 0.11632,0.22298 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'b' at screen 0.30680,0.20918 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'c' at screen 0.19425,0.71716 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'x' at screen 0.24000,0.42286 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'ra' at screen 0.05413,0.24291 center font ',7' tc rgb '#606060' noenhanced front
set label 'rb' at screen 0.27538,0.24291 center font ',7' tc rgb '#606060' noenhanced front
set label 'rc' at screen 0.13964,0.78294 center font ',7' tc rgb '#606060' noenhanced front
set label 'ab' at screen 0.16475,0.18363 center font ',7' tc rgb '#606060' noenhanced front
set label 'ca' at screen 0.12097,0.44977 center font ',7' tc rgb '#606060' noenhanced front
set label 'bc' at screen 0.21593,0.47417 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.32663
set bmargin at screen 0.03188; set tmargin at screen 0.92986
set xrange [-1.7437223:6.7437223]; set yrange [-2.05465288:8.55465288]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 0.5 dt 2 lc rgb '#606060', \
  data index 1 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 2 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 3 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2
set label '' at screen 0.50000,0.00893 center font ',7' tc rgb '#606060' noenhanced front
set label 'A' at screen 0.41436,0.33317 center font ',7' tc rgb '#202020' noenhanced front
set label 'B' at screen 0.58564,0.37465 center font ',7' tc rgb '#202020' noenhanced front
set label 'C' at screen 0.47278,0.62183 center font ',7' tc rgb '#202020' noenhanced front
set label 'l' at screen 0.56726,0.33175 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'm' at screen 0.44687,0.60411 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'n' at screen 0.41540,0.37104 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'k' at screen 0.51045,0.44070 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'b' at screen 0.43299,0.48812 center font ',7' tc rgb '#606060' noenhanced front
set label 'c' at screen 0.50000,0.33175 center font ',7' tc rgb '#606060' noenhanced front
set label 'a' at screen 0.52740,0.49935 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.33812; set rmargin at screen 0.66188
set bmargin at screen 0.03188; set tmargin at screen 0.92986
set xrange [-2.2437223:6.2437223]; set yrange [-3.80465288:6.80465288]
set border 0; unset xtics; unset ytics
plot data index 4 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 5 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 6 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 3
set label '' at screen 0.83525,0.00893 center font ',7' tc rgb '#606060' noenhanced front
set label 'P1' at screen 0.75134,0.23999 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.91916,0.23999 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.96451,0.53201 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.83878,0.72172 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.70598,0.53201 center font ',7' tc rgb '#202020' noenhanced front
set label 'l1' at screen 0.71844,0.63835 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'l2' at screen 0.95737,0.24711 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'l3' at screen 0.89951,0.28855 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'l4' at screen 0.80638,0.69763 center font ',7' tc rgb '#0072B2' noenhanced front
set label 'a1' at screen 0.72600,0.32197 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'a2' at screen 0.96220,0.44227 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'h2' at screen 0.91718,0.40617 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.75332,0.40617 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.90028,0.63382 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4' at screen 0.77022,0.63382 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.83525,0.29143 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.67337; set rmargin at screen 0.99713
set bmargin at screen 0.03188; set tmargin at screen 0.92986
set xrange [-2.2437223:6.2437223]; set yrange [-2.80465288:7.80465288]
set border 0; unset xtics; unset ytics
plot data index 7 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 8 using 1:2 with lines lw 1.1 lc rgb '#0072B2', \
  data index 9 using 1:2 with lines lw 0.6 lc rgb '#D55E00', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
