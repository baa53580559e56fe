# Figures along the path with the coplanarities kept
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' deformation.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 658,234 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 17.40cm,6.19cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'deformation.'.format
data = 'deformation.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 174 mm x 62 mm

# line 1, column 1, t = 0.00
set label 't = 0.00' at screen 0.09770,0.55443 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.19253
set bmargin at screen 0.58349; set tmargin at screen 0.99193
set xrange [-1.50570666:1.34751498]; set yrange [-1.29869294:0.888735938]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.46 lc rgb '#B9C3CC', \
  data index 2 using 1:2 with lines lw 0.585 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.71 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 0.836 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.17 lc rgb '#143653', \
  data index 7 using 1:2 with points pt 7 ps 0.351 lc rgb '#B9C3CC', \
  data index 8 using 1:2 with points pt 7 ps 0.351 lc rgb '#9AA8B5', \
  data index 9 using 1:2 with points pt 7 ps 0.351 lc rgb '#7A8C9C', \
  data index 10 using 1:2 with points pt 7 ps 0.351 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2, t = −0.14
set label 't = −0.14' at screen 0.29885,0.55443 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.20402; set rmargin at screen 0.39368
set bmargin at screen 0.58349; set tmargin at screen 0.99193
set xrange [-1.33679154:1.5164301]; set yrange [-0.43881731:1.74861157]
set border 0; unset xtics; unset ytics
plot data index 11 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 12 using 1:2 with lines lw 0.358 lc rgb '#B9C3CC', \
  data index 13 using 1:2 with lines lw 0.455 lc rgb '#9AA8B5', \
  data index 14 using 1:2 with lines lw 0.553 lc rgb '#7A8C9C', \
  data index 15 using 1:2 with lines lw 0.65 lc rgb '#5A7083', \
  data index 16 using 1:2 with lines lw 0.78 lc rgb '#38536B', \
  data index 17 using 1:2 with lines lw 0.91 lc rgb '#143653', \
  data index 18 using 1:2 with points pt 7 ps 0.273 lc rgb '#B9C3CC', \
  data index 19 using 1:2 with points pt 7 ps 0.273 lc rgb '#7A8C9C', \
  data index 20 using 1:2 with points pt 7 ps 0.273 lc rgb '#5A7083', \
  data index 21 using 1:2 with points pt 7 ps 0.273 lc rgb '#143653'
unset label; unset arrow

# line 1, column 3, t = 0.24
set label 't = 0.24' at screen 0.50000,0.55443 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.40517; set rmargin at screen 0.59483
set bmargin at screen 0.58349; set tmargin at screen 0.99193
set xrange [-1.77563016:1.07759148]; set yrange [-0.458946829:1.72848205]
set border 0; unset xtics; unset ytics
plot data index 22 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 23 using 1:2 with lines lw 0.548 lc rgb '#B9C3CC', \
  data index 24 using 1:2 with lines lw 0.697 lc rgb '#9AA8B5', \
  data index 25 using 1:2 with lines lw 0.847 lc rgb '#7A8C9C', \
  data index 26 using 1:2 with lines lw 0.996 lc rgb '#5A7083', \
  data index 27 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 28 using 1:2 with lines lw 1.39 lc rgb '#143653', \
  data index 29 using 1:2 with points pt 7 ps 0.418 lc rgb '#B9C3CC', \
  data index 30 using 1:2 with points pt 7 ps 0.418 lc rgb '#9AA8B5', \
  data index 31 using 1:2 with points pt 7 ps 0.418 lc rgb '#5A7083', \
  data index 32 using 1:2 with points pt 7 ps 0.418 lc rgb '#143653'
unset label; unset arrow

# line 1, column 4, t = 0.95
set label 't = 0.95' at screen 0.70115,0.55443 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.60632; set rmargin at screen 0.79598
set bmargin at screen 0.58349; set tmargin at screen 0.99193
set xrange [-2.26271363:0.590508007]; set yrange [-0.42732353:1.76010535]
set border 0; unset xtics; unset ytics
plot data index 33 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 34 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 35 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 36 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 37 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 38 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 39 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 40 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 41 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 42 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 43 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 44 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 5, t = 1.22
set label 't = 1.22' at screen 0.90230,0.55443 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.80747; set rmargin at screen 0.99713
set bmargin at screen 0.58349; set tmargin at screen 0.99193
set xrange [-0.998728303:1.85449333]; set yrange [-0.406900887:1.78052799]
set border 0; unset xtics; unset ytics
plot data index 45 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 46 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 47 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 48 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 49 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 50 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 51 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 52 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 53 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 54 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 1, t = 0.90
set label 't = 0.90' at screen 0.09770,0.06942 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00287; set rmargin at screen 0.19253
set bmargin at screen 0.09848; set tmargin at screen 0.49308
set xrange [-0.341621885:2.51159975]; set yrange [-0.94065076:1.17267733]
set border 0; unset xtics; unset ytics
plot data index 55 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 56 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 57 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 58 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 59 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 60 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 61 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 62 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 63 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 64 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 65 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 2, t = 1.11
set label 't = 1.11' at screen 0.29885,0.06942 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.20402; set rmargin at screen 0.39368
set bmargin at screen 0.09848; set tmargin at screen 0.49308
set xrange [-0.733180788:2.12004085]; set yrange [-1.83134227:0.281985818]
set border 0; unset xtics; unset ytics
plot data index 66 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 67 using 1:2 with lines lw 0.494 lc rgb '#B9C3CC', \
  data index 68 using 1:2 with lines lw 0.628 lc rgb '#9AA8B5', \
  data index 69 using 1:2 with lines lw 0.763 lc rgb '#7A8C9C', \
  data index 70 using 1:2 with lines lw 0.898 lc rgb '#5A7083', \
  data index 71 using 1:2 with lines lw 1.08 lc rgb '#38536B', \
  data index 72 using 1:2 with lines lw 1.26 lc rgb '#143653', \
  data index 73 using 1:2 with points pt 7 ps 0.377 lc rgb '#B9C3CC', \
  data index 74 using 1:2 with points pt 7 ps 0.377 lc rgb '#9AA8B5', \
  data index 75 using 1:2 with points pt 7 ps 0.377 lc rgb '#7A8C9C', \
  data index 76 using 1:2 with points pt 7 ps 0.377 lc rgb '#143653'
unset label; unset arrow

# line 2, column 3, t = 1.07
set label 't = 1.07' at screen 0.50000,0.06942 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.40517; set rmargin at screen 0.59483
set bmargin at screen 0.09848; set tmargin at screen 0.49308
set xrange [-2.08564218:0.767579458]; set yrange [-1.8101385:0.303189584]
set border 0; unset xtics; unset ytics
plot data index 77 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 78 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 79 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 80 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 81 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 82 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 83 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 84 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 85 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 86 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 87 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 88 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 89 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 4, t = 0.54
set label 't = 0.54' at screen 0.70115,0.06942 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.60632; set rmargin at screen 0.79598
set bmargin at screen 0.09848; set tmargin at screen 0.49308
set xrange [-2.07264593:0.780575706]; set yrange [-1.55557288:0.55775521]
set border 0; unset xtics; unset ytics
plot data index 90 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 91 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 92 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 93 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 94 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 95 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 96 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 97 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 98 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 99 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 100 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 101 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 5, t = 0.00
set label 't = 0.00' at screen 0.90230,0.06942 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.80747; set rmargin at screen 0.99713
set bmargin at screen 0.09848; set tmargin at screen 0.49308
set xrange [-1.50570666:1.34751498]; set yrange [-1.26164255:0.851685541]
set border 0; unset xtics; unset ytics
plot data index 102 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 103 using 1:2 with lines lw 0.46 lc rgb '#B9C3CC', \
  data index 104 using 1:2 with lines lw 0.585 lc rgb '#9AA8B5', \
  data index 105 using 1:2 with lines lw 0.71 lc rgb '#7A8C9C', \
  data index 106 using 1:2 with lines lw 0.836 lc rgb '#5A7083', \
  data index 107 using 1:2 with lines lw 1 lc rgb '#38536B', \
  data index 108 using 1:2 with lines lw 1.17 lc rgb '#143653', \
  data index 109 using 1:2 with points pt 7 ps 0.351 lc rgb '#B9C3CC', \
  data index 110 using 1:2 with points pt 7 ps 0.351 lc rgb '#9AA8B5', \
  data index 111 using 1:2 with points pt 7 ps 0.351 lc rgb '#7A8C9C', \
  data index 112 using 1:2 with points pt 7 ps 0.351 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
