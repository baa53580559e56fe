# f = 0 and g <= 0 have no solution: the Bernstein coefficients of g - 2 f are positive
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' combination.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,268 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,7.09cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'combination.'.format
data = 'combination.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 71 mm
set style textbox opaque noborder margins 0.6,0.6

# f = 0 and g ≤ 0
set label 'f = 0 and g ≤ 0' at screen 0.28879,0.96049 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.28879,0.03104 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.01149,0.52469 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.50862
set bmargin at screen 0.11993; set tmargin at screen 0.92945
unset logscale x
set xrange [-0.16:1.16]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [-1.82:2.82]
set ytics ('0' 0, '2' 2)
set border 3; set tics scale 0.4,0.2
plot \
  data index 0 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 1 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#0072B2', \
  data index 2 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 3 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 4 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 5 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#D55E00', \
  data index 6 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 7 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 8 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050'
unset label; unset arrow

# every coefficient of g − 2 f is positive
set label 'every coefficient of g − 2 f is positive' at screen 0.76293,0.96049 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.76293,0.03104 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.54310; set rmargin at screen 0.98276
set bmargin at screen 0.11993; set tmargin at screen 0.92945
unset logscale x
set xrange [-0.16:1.16]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [-1.82:2.82]
set ytics ('' 0, '' 2)
set border 3; set tics scale 0.4,0.2
plot \
  data index 9 using 1:2 with lines lw 1.2 dt 1 lc rgb '#0072B2', \
  data index 10 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#0072B2', \
  data index 11 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 12 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#D55E00', \
  data index 13 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 14 using 1:2:3 with labels left offset character 0.5,0.5 noenhanced tc rgb '#000000', \
  data index 15 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 16 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 17 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050'
unset label; unset arrow
unset multiplot
unset output
