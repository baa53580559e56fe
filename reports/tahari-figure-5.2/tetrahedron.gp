# The Bernstein polytope of (x, y, x y) on the unit square: a tetrahedron
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' tetrahedron.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,283 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,7.49cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'tetrahedron.'.format
data = 'tetrahedron.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 75 mm
set style textbox opaque noborder margins 0.6,0.6

# products of bound factors
set label 'products of bound factors' at screen 0.50000,0.96259 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.50000,-0.07081 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.02381,0.47328 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.03571; set rmargin at screen 0.96429
set bmargin at screen 0.01336; set tmargin at screen 0.93320
unset logscale x
set xrange [-0.7425559592577449:1.0347909327039004]
set xtics ('' -0.5, '' 0, '' 0.5, '' 1)
unset logscale y
set yrange [-0.06:1.508909126252671]
set ytics ('' 0, '' 0.5, '' 1, '' 1.5)
set border 0; set tics scale 0
plot \
  data index 0 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E8F1F8', \
  data index 0 using 1:2 with lines lw 0.1 dt 1 lc rgb '#0072B2', \
  data index 1 using 1:2 with lines lw 0.5 dt 2 lc rgb '#0072B2', \
  data index 2 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 3 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 4 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 5 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 6 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 7 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 8 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 9 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 10 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 11 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 12 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 13 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 14 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 15 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 16 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 17 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 18 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 19 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 20 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 21 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 22 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 23 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 24 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 25 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 26 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 27 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 28 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 29 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 30 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 31 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 32 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 33 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 34 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 35 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
