# Sketches of the hexahedron, problem 3, and of the flat problem 4 (as drawn: random, and so not flat yet), with the parameters of their lengths
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figure-5.4.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 317,606 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 8.40cm,16.03cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figure-5.4.'.format
data = 'figure-5.4.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 84 mm x 160 mm
set label '' at screen 0.52976,0.98129 center font ',8' tc rgb '#202020' noenhanced front
set label 'hexahedron' at screen 0.02619,0.79918 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1
set label '' at screen 0.52976,0.62144 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.09330,0.92009 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.28200,0.64330 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.49268,0.95506 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.27306,0.87476 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.97340,0.86823 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.62338,0.87727 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.24098,0.82178 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.85745,0.74342 center font ',7' tc rgb '#202020' noenhanced front
set label 'h1' at screen 0.21548,0.90835 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.21436,0.88056 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.37897,0.92505 center font ',7' tc rgb '#606060' noenhanced front
set label 'h9' at screen 0.85889,0.81553 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.41970,0.88934 center font ',7' tc rgb '#606060' noenhanced front
set label 'h10' at screen 0.39233,0.85907 center font ',7' tc rgb '#606060' noenhanced front
set label 'h8' at screen 0.76911,0.87731 center font ',7' tc rgb '#606060' noenhanced front
set label 'h4' at screen 0.72196,0.91531 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0' at screen 0.23502,0.78819 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7' at screen 0.55470,0.71791 center font ',7' tc rgb '#606060' noenhanced front
set label 'h2' at screen 0.36377,0.80424 center font ',7' tc rgb '#606060' noenhanced front
set label 'h11' at screen 0.55632,0.80524 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06548; set rmargin at screen 0.99405
set bmargin at screen 0.63267; set tmargin at screen 0.96570
set xrange [-0.10458595:1.7858866]; set yrange [-1.06902593:0.225167768]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 2 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
set label 'hexahedron-flat' at screen 0.02619,0.31789 center rotate by 90 font ',8' tc rgb '#202020' noenhanced front

# line 2, column 1
set label '' at screen 0.52976,0.00437 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.52766,0.56903 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.08613,0.35084 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.50374,0.30186 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.97159,0.60399 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.55359,0.15573 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.55086,0.53209 center font ',7' tc rgb '#202020' noenhanced front
set label 'P6' at screen 0.44855,0.30939 center font ',7' tc rgb '#202020' noenhanced front
set label 'P7' at screen 0.53539,0.02623 center font ',7' tc rgb '#202020' noenhanced front
set label 'h4' at screen 0.55228,0.19107 center font ',7' tc rgb '#606060' noenhanced front
set label 'h9' at screen 0.55486,0.10419 center font ',7' tc rgb '#606060' noenhanced front
set label 'h10' at screen 0.45096,0.36225 center font ',7' tc rgb '#606060' noenhanced front
set label 'h2' at screen 0.31802,0.32783 center font ',7' tc rgb '#606060' noenhanced front
set label 'h5' at screen 0.75596,0.54440 center font ',7' tc rgb '#606060' noenhanced front
set label 'h1' at screen 0.73099,0.58827 center font ',7' tc rgb '#606060' noenhanced front
set label 'h6' at screen 0.47274,0.44094 center font ',7' tc rgb '#606060' noenhanced front
set label 'h11' at screen 0.46484,0.17920 center font ',7' tc rgb '#606060' noenhanced front
set label 'h0' at screen 0.30110,0.46293 center font ',7' tc rgb '#606060' noenhanced front
set label 'h8' at screen 0.51433,0.34430 center font ',7' tc rgb '#606060' noenhanced front
set label 'h7' at screen 0.34746,0.20275 center font ',7' tc rgb '#606060' noenhanced front
set label 'h3' at screen 0.69859,0.44874 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.06548; set rmargin at screen 0.99405
set bmargin at screen 0.01559; set tmargin at screen 0.62019
set xrange [-0.910063013:0.918326441]; set yrange [-2.03348833:0.238915488]
set border 0; unset xtics; unset ytics
plot data index 10 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 11 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 12 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 13 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 14 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 15 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 16 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 17 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 18 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 19 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
