# The first solution and the new sketches from it (figure 4.6, which has four, mirror images included: two up to isometry, one of them the solution)
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-4.6.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,213 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,5.63cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-4.6.'.format
data = 'figure-4.6.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 56 mm
set label 'pentahedron' at screen 0.50000,0.94672 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1, the solution
set label 'the solution' at screen 0.24702,0.07636 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.02866,0.35662 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.19634,0.27130 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.31697,0.31207 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.17150,0.41052 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.25766,0.74496 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.46539,0.43455 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00595; set rmargin at screen 0.48810
set bmargin at screen 0.10833; set tmargin at screen 0.90233
set xrange [-0.264058986:2.21426683]; set yrange [-0.855544534:1.88040308]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 2 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 11 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 12 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2, branch ++++
set label 'branch ++++' at screen 0.75298,0.07636 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.60869,0.83741 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.82909,0.73743 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.89726,0.81777 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.76801,0.87202 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.86104,0.46524 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.68537,0.13863 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.51190; set rmargin at screen 0.99405
set bmargin at screen 0.10833; set tmargin at screen 0.90233
set xrange [-0.646138833:1.83218698]; set yrange [-2.42647146:0.309476159]
set border 0; unset xtics; unset ytics
plot data index 13 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 14 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 15 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 16 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 17 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 18 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 19 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 20 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 21 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 22 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 23 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
