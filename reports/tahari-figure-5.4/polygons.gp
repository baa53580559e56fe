# The polytope of (x, x^2) cut by y >= x - 1/4, and a polygon around (x, exp x)
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' polygons.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,258 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,6.83cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'polygons.'.format
data = 'polygons.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 68 mm
set style textbox opaque noborder margins 0.6,0.6

# with squares about the midpoint
set label 'with squares about the midpoint' at screen 0.27874,0.95897 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.27874,0.03223 center font ',7' tc rgb '#202020' noenhanced front
set label 'x²' at screen 0.01149,0.52564 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.48851
set bmargin at screen 0.12454; set tmargin at screen 0.92674
unset logscale x
set xrange [-0.08:1.08]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [-0.08:1.08]
set ytics ('0.0' 0, '0.5' 0.5, '1.0' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 0 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 1 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 1 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 2 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 3 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00'
unset label; unset arrow

# chord and tangents of exp
set label 'chord and tangents of exp' at screen 0.77299,0.95897 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.77299,0.03223 center font ',7' tc rgb '#202020' noenhanced front
set label 'exp x' at screen 0.50862,0.52564 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.56322; set rmargin at screen 0.98276
set bmargin at screen 0.12454; set tmargin at screen 0.92674
unset logscale x
set xrange [-0.08:1.08]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [0.8625374537232764:2.855744374735769]
set ytics ('1.0' 1, '1.5' 1.5, '2.0' 2, '2.5' 2.5)
set border 3; set tics scale 0.4,0.2
plot \
  data index 4 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 4 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 5 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 6 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
