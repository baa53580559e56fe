# The seven figures, as figure 4.5 has them, and those on the path of the sketch
# Written by gcslab report. To draw it again after a change:
#   gnuplot -e 'format="svg"' figures.gp
# Line widths and font sizes are points, as printed at the figure's own size.
if (!exists("format")) format = "pdf"
if (format eq "svg") set terminal svg size 616,1522 font 'DejaVu Sans,7' fontscale 1.3333 linewidth 1.3333 dashlength 0.7 enhanced background rgb 'white'
if (format eq "pdf") set terminal pdfcairo size 16.30cm,40.27cm font 'DejaVu Sans,7' fontscale 0.75 linewidth 2 dashlength 0.5 enhanced
set output 'figures.'.format
data = 'figures.dat'
set encoding utf8
set minussign
unset key
set border 15 lw 0.5 lc rgb '#505050' front
set tics nomirror scale 0.4,0.2 textcolor rgb '#202020'
set xtics offset 0,0.3
set ytics offset 0.4,0
set multiplot # 163 mm x 403 mm
set label 'sketch path' at screen 0.24847,0.99255 center font ',8' tc rgb '#202020' noenhanced front
set label 'every solution, proved' at screen 0.75153,0.99255 center font ',8' tc rgb '#202020' noenhanced front

# line 1, column 1, 4 solutions
set label '4 solutions' at screen 0.24847,0.85920 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.03095,0.90280 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.03095,0.87012 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.17012,0.87339 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.20934,0.89424 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.24979,0.98135 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.46691,0.89510 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.86367; set tmargin at screen 0.98634
set xrange [-0.226550435:2.37217999]; set yrange [-0.46640128:1.13857827]
set border 0; unset xtics; unset ytics
plot data index 0 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 1 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 2 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 3 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 4 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 5 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 6 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 7 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 8 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 9 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 10 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 11 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 1, column 2, 8 solutions
set label '8 solutions' at screen 0.75153,0.85920 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.53402,0.90280 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.53402,0.87012 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.67318,0.87339 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.71241,0.89424 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.75286,0.98135 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.96998,0.89510 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.86367; set tmargin at screen 0.98634
set xrange [-0.226550435:2.37217999]; set yrange [-0.46640128:1.13857827]
set border 0; unset xtics; unset ytics
plot data index 12 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 13 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 14 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 15 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 16 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 17 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 18 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 19 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 20 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 21 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 22 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 23 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 1, 4 solutions
set label '4 solutions' at screen 0.24847,0.66152 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.07771,0.70164 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.08435,0.67022 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.21161,0.67533 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.23704,0.70432 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.42028,0.75185 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.24055,0.84476 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.66599; set tmargin at screen 0.84976
set xrange [-0.473442197:2.12528823]; set yrange [-0.46640128:1.93783911]
set border 0; unset xtics; unset ytics
plot data index 24 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 25 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 26 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 27 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 28 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 29 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 30 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 31 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 32 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 33 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 34 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 2, column 2, 8 solutions
set label '8 solutions' at screen 0.75153,0.66152 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.58078,0.70164 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.58742,0.67022 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.71468,0.67533 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.74011,0.70432 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.92335,0.75185 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.74362,0.84476 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.66599; set tmargin at screen 0.84976
set xrange [-0.473442197:2.12528823]; set yrange [-0.46640128:1.93783911]
set border 0; unset xtics; unset ytics
plot data index 35 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 36 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 37 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 38 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 39 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 40 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 41 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 42 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 43 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 44 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 45 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 3, column 1, 2 solutions
set label '2 solutions' at screen 0.24847,0.49522 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.37314,0.53706 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.35731,0.50468 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.43131,0.52034 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.23222,0.52103 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.30588,0.61101 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.06932,0.64706 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.49969; set tmargin at screen 0.65209
set xrange [-1.87567047:0.723059952]; set yrange [-0.46640128:1.52737866]
set border 0; unset xtics; unset ytics
plot data index 46 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 47 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 48 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 49 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 50 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 51 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 52 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 53 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 54 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 55 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 56 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 57 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 3, column 2, 8 solutions
set label '8 solutions' at screen 0.75153,0.49522 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.87621,0.53706 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.86038,0.50468 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.93438,0.52034 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.73529,0.52103 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.80894,0.61101 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.57239,0.64706 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.49969; set tmargin at screen 0.65209
set xrange [-1.87567047:0.723059952]; set yrange [-0.46640128:1.52737866]
set border 0; unset xtics; unset ytics
plot data index 58 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 59 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 60 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 61 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 62 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 63 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 64 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 65 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 66 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 67 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 68 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 69 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 4, column 1, 2 solutions
set label '2 solutions' at screen 0.24847,0.33984 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.32712,0.38292 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.33918,0.35322 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.48229,0.35076 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.44398,0.37328 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.27071,0.42600 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.01464,0.47933 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.34431; set tmargin at screen 0.48578
set xrange [-1.79967594:0.799054489]; set yrange [-0.527581787:1.32335077]
set border 0; unset xtics; unset ytics
plot data index 70 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 71 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 72 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 73 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 74 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 75 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 76 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 77 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 78 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 79 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 80 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 81 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 4, column 2, 8 solutions
set label '8 solutions' at screen 0.75153,0.33984 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.83019,0.38292 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.84225,0.35322 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.98536,0.35076 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.94704,0.37328 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.77377,0.42600 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.51771,0.47933 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.34431; set tmargin at screen 0.48578
set xrange [-1.79967594:0.799054489]; set yrange [-0.527581787:1.32335077]
set border 0; unset xtics; unset ytics
plot data index 82 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 83 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 84 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 85 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 86 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 87 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 88 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 89 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 90 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 91 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 92 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 93 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 5, column 1, 2 solutions
set label '2 solutions' at screen 0.24847,0.13475 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.21721,0.17978 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.22121,0.14345 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.34826,0.15611 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.14960,0.15709 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.16661,0.23256 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.31826,0.32616 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.13922; set tmargin at screen 0.33040
set xrange [-1.19811246:1.40061796]; set yrange [-0.46640128:2.03477903]
set border 0; unset xtics; unset ytics
plot data index 94 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 95 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 96 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 97 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 98 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 99 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 100 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 101 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 102 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 103 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 104 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 105 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 5, column 2, 8 solutions
set label '8 solutions' at screen 0.75153,0.13475 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.72028,0.17978 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.72428,0.14345 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.85133,0.15611 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.65267,0.15709 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.66968,0.23256 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.82133,0.32616 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.13922; set tmargin at screen 0.33040
set xrange [-1.19811246:1.40061796]; set yrange [-0.46640128:2.03477903]
set border 0; unset xtics; unset ytics
plot data index 106 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 107 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 108 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 109 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 110 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 111 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 112 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 113 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 114 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 115 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 116 using 1:2 with points pt 7 ps 0.42 lc rgb '#38536B', \
  data index 117 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 6, column 1, 2 solutions, flat
set label '2 solutions, flat' at screen 0.24847,0.07331 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.04599,0.11925 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.03486,0.08435 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.19686,0.08423 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.02666,0.09427 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.19329,0.12032 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.47014,0.10412 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.07778; set tmargin at screen 0.12532
set xrange [-0.247226245:2.35150418]; set yrange [-0.467994632:0.153891962]
set border 0; unset xtics; unset ytics
plot data index 118 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 119 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 120 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 121 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 122 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 123 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 124 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 125 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 126 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 127 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 128 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 6, column 2, 4 solutions, flat
set label '4 solutions, flat' at screen 0.75153,0.07331 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.54906,0.11925 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.53793,0.08435 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.69992,0.08423 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.52973,0.09427 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.69636,0.12032 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.97321,0.10412 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.07778; set tmargin at screen 0.12532
set xrange [-0.247226245:2.35150418]; set yrange [-0.467994632:0.153891962]
set border 0; unset xtics; unset ytics
plot data index 129 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 130 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 131 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 132 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 133 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 134 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 135 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 136 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 137 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 138 using 1:2 with points pt 7 ps 0.42 lc rgb '#5A7083', \
  data index 139 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow

# line 7, column 1
set label '' at screen 0.24847,0.01068 center font ',7' tc rgb '#606060' noenhanced front
set label '–' at screen 0.24847,0.03951 center font ',7' tc rgb '#606060' noenhanced front
set lmargin at screen 0.00307; set rmargin at screen 0.49387
set bmargin at screen 0.01515; set tmargin at screen 0.06388
set border 0; unset xtics; unset ytics
set xrange [0:1]; set yrange [0:1]
plot NaN
unset label; unset arrow

# line 7, column 2, 4 solutions, flat
set label '4 solutions, flat' at screen 0.75153,0.01068 center font ',7' tc rgb '#606060' noenhanced front
set label 'P0' at screen 0.96013,0.05743 center font ',7' tc rgb '#202020' noenhanced front
set label 'P1' at screen 0.94900,0.02253 center font ',7' tc rgb '#202020' noenhanced front
set label 'P2' at screen 0.97928,0.04366 center font ',7' tc rgb '#202020' noenhanced front
set label 'P3' at screen 0.79625,0.05392 center font ',7' tc rgb '#202020' noenhanced front
set label 'P4' at screen 0.74559,0.01938 center font ',7' tc rgb '#202020' noenhanced front
set label 'P5' at screen 0.52484,0.04451 center font ',7' tc rgb '#202020' noenhanced front
set lmargin at screen 0.50613; set rmargin at screen 0.99693
set bmargin at screen 0.01515; set tmargin at screen 0.06388
set xrange [-2.32495507:0.273775355]; set yrange [-0.507597703:0.129936521]
set border 0; unset xtics; unset ytics
plot data index 140 using 1:2 with filledcurves closed fs transparent solid 0.13 noborder lc rgb '#56B4E9', \
  data index 141 using 1:2 with lines lw 0.55 lc rgb '#B9C3CC', \
  data index 142 using 1:2 with lines lw 0.7 lc rgb '#9AA8B5', \
  data index 143 using 1:2 with lines lw 0.85 lc rgb '#7A8C9C', \
  data index 144 using 1:2 with lines lw 1 lc rgb '#5A7083', \
  data index 145 using 1:2 with lines lw 1.2 lc rgb '#38536B', \
  data index 146 using 1:2 with lines lw 1.4 lc rgb '#143653', \
  data index 147 using 1:2 with points pt 7 ps 0.42 lc rgb '#B9C3CC', \
  data index 148 using 1:2 with points pt 7 ps 0.42 lc rgb '#9AA8B5', \
  data index 149 using 1:2 with points pt 7 ps 0.42 lc rgb '#7A8C9C', \
  data index 150 using 1:2 with points pt 7 ps 0.42 lc rgb '#143653'
unset label; unset arrow
unset multiplot
unset output
