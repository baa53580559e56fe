# How the sketch becomes the first solution
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' deformation.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,246 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,6.50cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'deformation.'.format
data = 'deformation.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 65 mm

# line 1, column 1, t = 0.00
set label 't = 0.00' at screen 0.12284,0.57140 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.24282
set bmargin at screen 0.59908; set tmargin at screen 0.99231
set xrange [-0.750108265:1.09883568]; set yrange [-0.444194602:0.688055085]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with lines lw 0.514 lc rgb '#B9C3CC', \
  data index 1 using 1:2 with lines lw 0.655 lc rgb '#9AA8B5', \
  data index 2 using 1:2 with lines lw 0.795 lc rgb '#7A8C9C', \
  data index 3 using 1:2 with lines lw 0.935 lc rgb '#5A7083', \
  data index 4 using 1:2 with lines lw 1.12 lc rgb '#38536B', \
  data index 5 using 1:2 with lines lw 1.31 lc rgb '#143653', \
  data index 6 using 1:2 with points pt 7 ps 0.393 lc rgb '#B9C3CC', \
  data index 7 using 1:2 with points pt 7 ps 0.393 lc rgb '#9AA8B5', \
  data index 8 using 1:2 with points pt 7 ps 0.393 lc rgb '#7A8C9C', \
  data index 9 using 1:2 with points pt 7 ps 0.393 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2, t = 0.07
set label 't = 0.07' at screen 0.37428,0.57140 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.25431; set rmargin at screen 0.49425
set bmargin at screen 0.59908; set tmargin at screen 0.99231
set xrange [-0.714945583:1.13399836]; set yrange [-0.333123206:0.799126481]
set border 0; unset xtics; unset ytics
plot data index 10 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 11 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 12 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 13 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 14 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 15 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 16 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 17 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 18 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 19 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 3, t = 0.19
set label 't = 0.19' at screen 0.62572,0.57140 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.50575; set rmargin at screen 0.74569
set bmargin at screen 0.59908; set tmargin at screen 0.99231
set xrange [-0.700505205:1.14843874]; set yrange [-0.437995183:0.694254504]
set border 0; unset xtics; unset ytics
plot data index 20 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 21 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 22 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 23 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 24 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 25 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 26 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 27 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 28 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 29 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 30 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 4, t = 0.30
set label 't = 0.30' at screen 0.87716,0.57140 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.75718; set rmargin at screen 0.99713
set bmargin at screen 0.59908; set tmargin at screen 0.99231
set xrange [-0.794010464:1.05493348]; set yrange [-0.722978407:0.409271279]
set border 0; unset xtics; unset ytics
plot data index 31 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 32 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 33 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 34 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 35 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 36 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 37 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 38 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 39 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 40 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 1, t = 0.42
set label 't = 0.42' at screen 0.12284,0.06614 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.24282
set bmargin at screen 0.09382; set tmargin at screen 0.51295
set xrange [-0.762225224:1.08671872]; set yrange [-0.881794889:0.325032886]
set border 0; unset xtics; unset ytics
plot data index 41 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 42 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 43 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 44 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 45 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 46 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 47 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 48 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 49 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 50 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 51 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 2, t = 0.58
set label 't = 0.58' at screen 0.37428,0.06614 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.25431; set rmargin at screen 0.49425
set bmargin at screen 0.09382; set tmargin at screen 0.51295
set xrange [-0.64686166:1.20208228]; set yrange [-1.00635977:0.200468009]
set border 0; unset xtics; unset ytics
plot data index 52 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 53 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 54 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 55 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 56 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 57 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 58 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 59 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 60 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 61 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 3, t = 0.78
set label 't = 0.78' at screen 0.62572,0.06614 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.50575; set rmargin at screen 0.74569
set bmargin at screen 0.09382; set tmargin at screen 0.51295
set xrange [-0.510098168:1.33884578]; set yrange [-1.10784157:0.0989862041]
set border 0; unset xtics; unset ytics
plot data index 62 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 63 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 64 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 65 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 66 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 67 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 68 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 69 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 70 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 71 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 72 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 4, t = 1.00
set label 't = 1.00' at screen 0.87716,0.06614 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.75718; set rmargin at screen 0.99713
set bmargin at screen 0.09382; set tmargin at screen 0.51295
set xrange [-0.386312565:1.46263138]; set yrange [-1.16254169:0.0442860825]
set border 0; unset xtics; unset ytics
plot data index 73 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 74 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 75 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 76 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 77 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 78 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 79 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 80 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 81 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 82 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 83 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 84 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
