# Control points of a surface z = f(x1, x2), and what their hull leaves of an interval
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' projection.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,313 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,8.29cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'projection.'.format
data = 'projection.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 83 mm
set style textbox opaque noborder margins 0.6,0.6

# surface, control points, z = 0
set label 'surface, control points, z = 0' at screen 0.27874,0.90693 center font ',8' tc rgb '#202020' noenhanced front
set label '' at screen 0.27874,0.02655 center font ',7' tc rgb '#202020' noenhanced front
set label '' at screen 0.01149,0.49148 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.48851
set bmargin at screen 0.10260; set tmargin at screen 0.88037
unset logscale x
set xrange [-0.7425559592577449:1.0347909327039004]
set xtics ('' -0.5, '' 0, '' 0.5, '' 1)
unset logscale y
set yrange [-0.06:1.508909126252671]
set ytics ('' 0, '' 0.5, '' 1, '' 1.5)
set border 0; set tics scale 0
plot \
  data index 0 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#EFEFEF', \
  data index 0 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 1 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
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
  data index 23 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 24 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 25 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 26 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 27 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 28 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 29 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 30 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 31 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 32 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 33 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 34 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 35 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 36 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 37 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 38 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 39 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050', \
  data index 40 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 41 using 1:2:3 with labels center boxed noenhanced tc rgb '#505050'
unset label; unset arrow

# seen along x2
set label 'seen along x2' at screen 0.77299,0.96620 center font ',8' tc rgb '#202020' noenhanced front
set label 'x1' at screen 0.77299,0.02655 center font ',7' tc rgb '#202020' noenhanced front
set label 'z' at screen 0.50862,0.52112 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.56322; set rmargin at screen 0.98276
set bmargin at screen 0.10260; set tmargin at screen 0.93965
unset logscale x
set xrange [-0.08:1.08]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [-1.0150000000000001:1.0150000000000001]
set ytics ('−1' -1, '0' 0, '1' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 42 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 42 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 43 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 44 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 45 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 46 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 47 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 48 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 49 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 50 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 51 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 52 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 53 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 54 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 55 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 56 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 57 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 58 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 59 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 60 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 61 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 62 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 63 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 64 using 1:2 with lines lw 0.25 dt 1 lc rgb '#707070', \
  data index 65 using 1:2 with lines lw 0.4 dt 1 lc rgb '#505050', \
  data index 66 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00', \
  data index 67 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
