# Sketch of 6p7d3a2c: dashed, pairs of points of which only angles speak
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-3.8.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 306,298 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.10cm,7.88cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-3.8.'.format
data = 'figure-3.8.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 81 mm x 79 mm
set label '6p7d3a2c' at screen 0.50000,0.96191 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.50000,0.00889 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.62667,0.05338 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.97028,0.33165 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.27099,0.44308 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.03503,0.16721 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.12371,0.90853 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.50405,0.67660 center font ',7' tc rgb '#202020' noenhanced front
set label 'a1' at screen 0.09706,0.27017 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'a2' at screen 0.14160,0.21740 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'a3' at screen 0.61752,0.16974 center font ',7' tc rgb '#D55E00' noenhanced front
set label 'h0' at screen 0.75733,0.23246 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.33432,0.78953 center font ',7' tc rgb '#606060' noenhanced front
set label 'h9' at screen 0.48008,0.28015 center font ',7' tc rgb '#606060' noenhanced front
set label 'h8' at screen 0.25020,0.66796 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7' at screen 0.73579,0.51526 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.58607,0.35135 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.62548,0.40780 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00617; set rmargin at screen 0.99383
set bmargin at screen 0.03174; set tmargin at screen 0.93017
set xrange [-1.2060372:0.765635703]; set yrange [-0.0985836452:1.64533617]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.5 dt 2 lc rgb '#808080', \
  data index 2 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 3 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 4 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 5 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 6 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 7 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 8 using 1:2 with lines lw 0.6 lc rgb '#D55E00', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 11 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 12 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 13 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
