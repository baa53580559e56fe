# The Bernstein polytope of (x, x^2, x^3) on [0, 1]
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' tetrahedron.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,322 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,8.52cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'tetrahedron.'.format
data = 'tetrahedron.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 85 mm
set style textbox opaque noborder margins 0.6,0.6

# all Bernstein polynomials of degree 3
set label 'all Bernstein polynomials of degree 3' at screen 0.25000,0.96714 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.25000,-0.06220 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.01149,0.47653 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.01724; set rmargin at screen 0.48276
set bmargin at screen 0.01174; set tmargin at screen 0.94132
unset logscale x
set xrange [-0.06:1.3889260487773494]
set xtics ('' 0, '' 0.5, '' 1)
unset logscale y
set yrange [-0.24839554894178487:1.1683771399088632]
set ytics ('' 0, '' 0.5, '' 1)
set border 0; set tics scale 0
plot \
  data index 0 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E8F1F8', \
  data index 0 using 1:2 with lines lw 0.1 dt 1 lc rgb '#0072B2', \
  data index 1 using 1:2 with lines lw 0.5 dt 2 lc rgb '#0072B2', \
  data index 2 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 3 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 4 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 5 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 6 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 7 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 8 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 9 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 10 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 11 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 12 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 13 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 14 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00'
unset label; unset arrow

# the solver's polytope
set label 'the solver''s polytope' at screen 0.75000,0.96714 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.75000,-0.06220 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.51724; set rmargin at screen 0.98276
set bmargin at screen 0.01174; set tmargin at screen 0.94132
unset logscale x
set xrange [-0.06:1.3889260487773494]
set xtics ('' 0, '' 0.5, '' 1)
unset logscale y
set yrange [-0.24839554894178487:1.1683771399088632]
set ytics ('' 0, '' 0.5, '' 1)
set border 0; set tics scale 0
plot \
  data index 15 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#E8F1F8', \
  data index 15 using 1:2 with lines lw 0.1 dt 1 lc rgb '#0072B2', \
  data index 16 using 1:2 with lines lw 0.5 dt 2 lc rgb '#0072B2', \
  data index 17 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 18 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 19 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 20 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 21 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 22 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 23 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 24 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 25 using 1:2 with lines lw 0.9 dt 1 lc rgb '#0072B2', \
  data index 26 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 27 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 28 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 29 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 30 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 31 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 32 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
