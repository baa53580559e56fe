# Two de Casteljau iterations on the graph of a cubic, with the hulls of the control points
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' hulls.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,190 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,5.03cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'hulls.'.format
data = 'hulls.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 50 mm
set style textbox opaque noborder margins 0.6,0.6

# control points
set label 'control points' at screen 0.20977,0.94428 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.20977,0.04378 center font ',7' tc rgb '#202020' noenhanced front
set label 'y' at screen 0.01149,0.53483 center rotate by 90 font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.06897; set rmargin at screen 0.35057
set bmargin at screen 0.16915; set tmargin at screen 0.90050
unset logscale x
set xrange [-0.08:1.08]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [-0.89:1.1400000000000001]
set ytics ('0' 0, '1' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 0 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 0 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 1 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 2 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 3 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00'
unset label; unset arrow

# 1 iteration
set label '1 iteration' at screen 0.52586,0.94428 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.52586,0.04378 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.38506; set rmargin at screen 0.66667
set bmargin at screen 0.16915; set tmargin at screen 0.90050
unset logscale x
set xrange [-0.08:1.08]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [-0.89:1.1400000000000001]
set ytics ('' 0, '' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 4 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 4 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 5 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 5 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 6 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 7 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 8 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 9 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 10 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00'
unset label; unset arrow

# 2 iterations
set label '2 iterations' at screen 0.84195,0.94428 center font ',8' tc rgb '#202020' noenhanced front
set label 'x' at screen 0.84195,0.04378 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.70115; set rmargin at screen 0.98276
set bmargin at screen 0.16915; set tmargin at screen 0.90050
unset logscale x
set xrange [-0.08:1.08]
set xtics ('0.0' 0, '0.5' 0.5, '1.0' 1)
unset logscale y
set yrange [-0.89:1.1400000000000001]
set ytics ('' 0, '' 1)
set border 3; set tics scale 0.4,0.2
plot \
  data index 11 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 11 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 12 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 12 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 13 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 13 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 14 using 1:2 with filledcurves closed fs solid 1 noborder lc rgb '#CFE3F1', \
  data index 14 using 1:2 with lines lw 0.5 dt 1 lc rgb '#0072B2', \
  data index 15 using 1:2 with lines lw 1.2 dt 1 lc rgb '#000000', \
  data index 16 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 17 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 18 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 19 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 20 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 21 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00', \
  data index 22 using 1:2 with lines lw 0.6 dt 2 lc rgb '#D55E00', \
  data index 23 using 1:2 with points pt 7 ps 0.4 lc rgb '#D55E00'
unset label; unset arrow
unset multiplot
unset output
