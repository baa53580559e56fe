# The Bernstein polytope of (x, x^2) on [0, 1], and how linear programs reduce 4 x^2 + x - 3 = 0
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' reduction.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,177 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,4.67cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'reduction.'.format
data = 'reduction.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 47 mm
set style textbox opaque noborder margins 0.6,0.6

# products of bound factors
set label 'products of bound factors' at screen 0.19636,0.94011 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.19636,0.04706 center font ',7' tc rgb '#202020' noenhanced front
set label 'x²' at screen 0.01149,0.53743 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.32375
set bmargin at screen 0.18182; set tmargin at screen 0.89305
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

# step 1: to [3/5, 7/9]
set label 'step 1: to [3/5, 7/9]' at screen 0.52586,0.94011 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.52586,0.04706 center font ',7' tc rgb '#202020' noenhanced front
set label 'x²' at screen 0.34387,0.53743 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.39847; set rmargin at screen 0.65326
set bmargin at screen 0.18182; set tmargin at screen 0.89305
unset logscale x
set xrange [-0.08:1.08]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [-0.08:1.08]
set ytics ('0.0' 0, '0.5' 0.5, '1.0' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 4 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 4 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 5 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 6 using 1:2 with lines lw 0.6 dt 1 lc rgb '#D55E00', \
  data index 7 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 8 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 9 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00'
unset label; unset arrow

# step 2: width 0.18 to 0.003
set label 'step 2: width 0.18 to 0.003' at screen 0.85536,0.94011 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.85536,0.04706 center font ',7' tc rgb '#202020' noenhanced front
set label 'x²' at screen 0.67337,0.53743 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.72797; set rmargin at screen 0.98276
set bmargin at screen 0.18182; set tmargin at screen 0.89305
unset logscale x
set xrange [0.5857777777777775:0.7920000000000003]
set xtics ('0.6' 0.6, '0.7' 0.7)
unset logscale y
set yrange [0.34040493827160456:0.6245333333333337]
set ytics ('0.4' 0.4, '0.5' 0.5, '0.6' 0.6)
set border 3; set tics scale 0.4,0.2
plot \
  data index 10 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 10 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 11 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 12 using 1:2 with lines lw 0.6 dt 1 lc rgb '#D55E00', \
  data index 13 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 14 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 15 using 1:2 with lines lw 1.2 dt 1 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
