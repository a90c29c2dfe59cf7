<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="en_US">
<context>
    <name>AlarmPanel</name>
    <message>
        <source>&amp;Acknowledge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You know of the chosen alarms; with none chosen, of all that are new</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;helve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the chosen alarms aside for a while; not those of high priority</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Bring back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the chosen alarms off the shelf</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sound</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A short sound for every new alarm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Many alarms at once: those of low priority are held back until it is quieter.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>CalibrationPanel</name>
    <message>
        <source>A&amp;GV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The AGV to calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Slee&amp;ptime</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time of a 45 degree turn. About 1,125 ms with a charged battery, more when it is weak.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timed: each step ends after the sleeptime. Measured: the robot ends each step by its wheel encoders.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Timed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Direction of the turn, seen from above</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>S&amp;tops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops in one full turn; a closing reading follows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>D&amp;well</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest time at a stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;bort</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop this turn; the wheels are set to zero</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress of the turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Table of stops</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Read this stop again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The AGV turns back to the chosen stop and reads it once more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the whole table as text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fit of each stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>T&amp;urn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Calibrate (Initialization)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Initialization turn: the AGV turns once on the spot, reads the floor tags at every stop and finds where it stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details of the turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the wheels while the AGV turns. A new speed scales the sleeptime: half the speed takes twice the time.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> mm/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Leave stable stops early</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A stop ends as soon as its tags are stable; off: every stop takes the whole dwell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the stops read so far say; the final result comes after the last one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whe&amp;el speed</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>EventPanel</name>
    <message>
        <source>Event log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the chosen lines, or all when none is chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Details</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show also what follows from the console&apos;s own commands, such as every start and stop of a robot</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>FloorTagPanel</name>
    <message>
        <source>Number, UID or AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Filter of the floor tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only tags whose number, UID or reader&apos;s AGV holds this text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State of the floor tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show only tags in this state</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;olumns</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the columns; also by the right mouse button on the heads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy as CS&amp;V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the rows in sight, in their order</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floor tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Double click or Enter shows the tag on the map</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>JogPanel</name>
    <message>
        <source>AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The AGV to drive</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ine</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A fifth of the speed, to place the AGV exactly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the faster wheel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Speed of the faster wheel. Hands never drive faster than 250 mm/s, nor than the plant file allows this AGV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop all was pressed. No AGV can be driven by hand until you release it. Look that the way is free.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Release</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Let hands drive again after Stop all, with a fresh press</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keys: W A S D or the arrow keys, two at once for a curve; space stops this AGV. They work only while the pad has the keyboard (blue frame): click it or press Ctrl+J.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The AGV drives into its dock by itself</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The AGV leaves its dock by itself, backwards</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The base of the AGV looks for its dock by itself, to charge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If the Wi-Fi fails, an AGV may drive on with its last speed: keep the switch on the AGV in reach.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>LinksPanel</name>
    <message>
        <source>&amp;Open RFID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the RFID reader of the chosen row; with none chosen, all readers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close RFID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the RFID reader of the chosen row; with none chosen, all readers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGVs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Read RFID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show which floor tags the reader of the chosen row reads now; opens it when it is closed. With none chosen, all readers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floor tags read now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Port…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the serial port of the UWB unit, and how the unit writes</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>AGV Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>SIMULATION: no real AGV is connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Links</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Event log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the console; every robot is stopped first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Abort turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the running turn of the chosen AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Stop all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stops all AGVs at once (Esc or Pause). Software stop, does not replace the emergency stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Whole plant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the whole plant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom in; the mouse wheel zooms to the pointer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Chosen AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the chosen AGV large</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the chosen AGV in the middle of the map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;grid</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show floor &amp;tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;stations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put all panels back to their places</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;About AGV Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;hoose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Calibrate (Initialization)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn the chosen AGV once on the spot and find where it stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Next panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move the keyboard to the next panel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the RFID &amp;reader for 10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reader of the chosen AGV loses its connection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Cut the r&amp;obot for 10 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen AGV loses its connection and keeps its last speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot &amp;error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen AGV reports an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Garbage from the RFID reader</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reader of the chosen AGV prints 300 bytes of noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Weak battery (10 %)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The chosen AGV turns more slowly than its sleeptime expects</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>20 &amp;dead floor tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floor tags anywhere never answer again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo all faults</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything but the battery is as it was</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;UWB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take the last edit of the UWB kit back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make the edit again that was taken back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Add anchor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add an anchor with the lowest free number; then enter where it stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove a&amp;nchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen anchors and their range corrections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add &amp;tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add a tag with the lowest free number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove ta&amp;gs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove the chosen tags from the list, and their range corrections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Place anchors…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find where the anchors stand from the ranges between them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Calibrate ranges…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Find range corrections with a tag that stands at a known point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>C&amp;orrection table…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrections…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is added to the range of each tag to each anchor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Replace anchors and tags by those of a file of this or another program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save to plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write anchors, tags, corrections and port into the plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Po&amp;rt…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose the serial port of the UWB unit, and how the unit writes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Write the anchors to a file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Trails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show UWB &amp;anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;UWB tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show t&amp;rails</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show un&amp;certainty of UWB tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show UWB ra&amp;nges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Circles of the ranges of the UWB tag that was clicked, or of the chosen AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;expected UWB accuracy</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How well the anchors can tell a place, from where they stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show &amp;overview when zoomed in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 minute</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2 metres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 metres</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure a distance on the map: click or drag from point to point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mo&amp;ve anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drag UWB anchors to their places, in steps of 10 mm; with Shift 1 mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the map as it is shown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the map as it is shown, as PNG, SVG or PDF</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A&amp;larms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the list of alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledge new ala&amp;rms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You know of the alarms chosen in the list; with none chosen, of all that are new</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of shift</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start of shift: check everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at plant file, links, batteries, floor tags, anchors, sleeptimes and disk; moves nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Drive by hand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the drive pad and give it the keyboard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floor tags</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>PlotPanel</name>
    <message>
        <source>S&amp;how</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What the curves are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whose curves</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much time the plot shows</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold the picture; the data go on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Keep the newest values in sight</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the picture as PNG, SVG or PDF, or the visible values as CSV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Truly at</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>True x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>True y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>True heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take this pose as the true one of the chosen AGV; its errors are counted from now on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Take its pose</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fill in the pose of now, to see how it drifts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Statistics of the visible values</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ResultCard</name>
    <message>
        <source>Appl&amp;y suggested sleeptime</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use this sleeptime for the next turns of this AGV, and keep it in the plant file if there is one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use the sleeptime from before again, in the plant file too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>ShiftPanel</name>
    <message>
        <source>Check &amp;everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at plant file, links, batteries, floor tags, anchors, sleeptimes and disk; takes a few seconds and moves nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show a&amp;ll</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List the checks that passed, too</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Results of the checks</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate one after the &amp;other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Every AGV that can turns once on the spot, one after the other: keep 500 mm around each of them clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop the turn that runs and start no other one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrations</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::AccuracyTexts</name>
    <message>
        <source>Expected UWB
accuracy, 95 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>over %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no position</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::AlarmLog</name>
    <message>
        <source>Alarm: %1. %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm acknowledged: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm over, not acknowledged: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm shelved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarm over: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::AlarmPanel</name>
    <message>
        <source>No alarms: nothing asks for you.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For 10 minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For 1 hour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For the shift, 8 hours</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::AlarmScreen</name>
    <message>
        <source>No alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show the list of alarms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarms: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Alarms: %1, %2 new</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::AnchorSurveyDialog</name>
    <message>
        <source>&amp;Flip east and west</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Move the anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Places found from the ranges between the anchors. Hollow: where the list has an anchor now. Filled: where it would go, and how far. Heights stay as they are.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Lay it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Turn by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closest to the present list, or with one anchor as the origin of the plant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ranges alone do not tell a plan from its mirror image</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Compute the places from the newest ranges between the anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the proposed places into the list; one Undo takes them back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close; the anchors stay where they are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>closest to the present list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>with %1 at the origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing the places…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The anchors do not range each other.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ranges minus distances: %1 (root mean square). Least certain place: ±%2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::AnchorSurveyView</name>
    <message>
        <source>Present and proposed places of the anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stays</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::CalibrationPanel</name>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot of %1 is not connected. Switch it on; it connects by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The RFID reader of %1 is closed. Press Open RFID.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop %1 of %2, %3. %4 left.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready. %1 turns once on the spot: keep %2 around it clear.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plant file names no AGV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No turn yet. Press Calibrate: each stop adds a row with the tags read and their RSSI.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot of %1 cannot connect: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The RFID reader of %1 does not deliver: %2.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::CorrectionDialog</name>
    <message>
        <source>Correction table</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Added to each measured range, in cm. A range that reads too long needs a negative correction. An empty cell adds nothing.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range corrections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No corrections: there are no anchors. Add them in the panel UWB anchors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No corrections: no tag is listed or heard. Add one in the panel UWB tags, or switch one on.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::EventPanel</name>
    <message>
        <source>Nothing has happened yet. Connections, turns and errors are written here.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::FloorTagPanel</name>
    <message>
        <source>All</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plant file names no floor tags. Add a grid or a list of surveyed tags to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No floor tag fits the filter.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::JogPad</name>
    <message>
        <source>Curve ahead to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ahead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve ahead to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn left on the spot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn right on the spot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve back to the left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve back to the right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive pad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hold W, A, S, D or an arrow key to drive while this pad has the keyboard; space stops this AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: drives as long as you hold it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop this AGV, whatever it does (space). Software stop, does not replace the emergency stop.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::JogPanel</name>
    <message>
        <source>It is driven already: mouse and keys do not drive together.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This window did not react for a moment, so the press was not sent. Press again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 drives: left wheel %2, right wheel %3.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1. Let go, then press again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be driven now: %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready. %1 drives as long as you hold an arrow.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::LinksPanel</name>
    <message>
        <source>No AGVs. The plant file names none; add them there and start again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Refused, not in the plant file: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1 reads no floor tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1 reads tag (RSSI): %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open UWB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Open RFID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close UWB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close RFID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the serial port of the UWB unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open the RFID reader of the chosen row; with none chosen, all readers</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the serial port of the UWB unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close the RFID reader of the chosen row; with none chosen, all readers</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::MainWindow</name>
    <message>
        <source>Links: %1 of %2 up, %3 disturbed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Links: %1 of %2 up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x %1   y %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plant: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop all</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop all AGVs now (Esc). Software stop, does not replace the emergency stop.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>About AGV Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;AGV Console&lt;/b&gt;&lt;p&gt;Locate, calibrate and watch the AGVs of a pipeless plant.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. Made with Qt, QCustomPlot and Eigen.&lt;/p&gt;</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;The simulation has ended.&lt;/b&gt; %1. Start the console again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots cannot connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robots connect to: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&lt;b&gt;No robot can connect.&lt;/b&gt; %1. It is tried again by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV Console[*]</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1[*] – AGV Console</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::MapControls</name>
    <message>
        <source>x %1, y %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Centre here</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Save the map as a picture</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map was saved as %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::MapWidget</name>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x %1, y %2, facing %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>May be moving: the connection was lost while the wheels were turning.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1, stop %2: antenna at x %3, y %4
Tags expected %5, seen %6, missed %7, unknown %8</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floor tag %1 (%2)
%3
x %4, y %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Station %1
x %2, y %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map of the plant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB tag %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB tag %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>On AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x %1, y %2, 95 % within %3 by %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ranges, %2 of them obstructed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2 exchanges missed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB anchor %1, %2
x %3, y %4, height %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Seen in this session</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing: a turn should have read it and did not</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown floor tag %1 was read here; the plant file does not name it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB positions here: 95 % within about %1, as the anchors stand</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No UWB position here: the anchors stand too much in one direction</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::MeasureTexts</name>
    <message>
        <source>%1 along x, %2 along y</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::NextStep</name>
    <message>
        <source>The plant file holds no floor tags, so no AGV can be located.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plant file names no AGV. Add one there and start again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turning: AGV %1. Esc stops all AGVs.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>First press Open RFID, so that the AGVs can read the floor tags.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the AGVs on. They connect by themselves; none has yet.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not located yet: AGV %1. Choose one and press Calibrate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1 may still be moving: go and look, and use the switch of the AGV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No longer where it was located: AGV %1. Choose it and press Calibrate.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::PictureTexts</name>
    <message>
        <source>Picture (*.png)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drawing (*.svg)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::PlantFileDialog</name>
    <message>
        <source>&amp;Choose another file…</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use the built-in plant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plant file cannot be used.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Open plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plant files (*.json);;All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::PlotPanel</name>
    <message>
        <source>30 seconds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>2 minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>10 minutes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>1 hour</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Everything</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All AGVs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time since the start, s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share that is not larger, %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Type where the AGV truly is, choose the AGV above, and press Use.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No position yet: calibrate an AGV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No UWB ranges yet: open the UWB unit and switch a tag on.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing yet: connect an AGV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Statistics of the visible part of the curves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export the plot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Visible values (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The plot was saved as %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::RangeCalibrationDialog</name>
    <message>
        <source>%1 of the known point in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate ranges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the tag at a point whose place you know, with a free view of every anchor. Keep it still and step aside while ranges are collected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the tag&apos;s antenna above the floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source> s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of an &amp;AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take over where an AGV stands now; with the tag&apos;s place on it, when it carries the tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>number or ID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Place of this &amp;floor tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Take over where the floor tag with this number or ID lies</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Known point (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Progress</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Corrections found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No ranges yet. Choose the tag, enter where it stands, and start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use these corrections</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put them into the correction table; one Undo takes them back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No AGV is located yet: calibrate one first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no floor tag &quot;%1&quot;.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 floor tags end in &quot;%2&quot;: enter more digits.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Give up this collection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collect ranges of the tag at the known point</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close; the correction table stays as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There are no anchors. Add them in the panel UWB anchors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The UWB unit is not connected. Open it in the panel Links.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No tag is listed or heard. Switch the tag on, or add it in the panel UWB tags.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No corrections: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finished. Look at the spread, then use or discard the corrections of %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finished, but some ranges vary much: was the view blocked, or the tag moved?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Collecting ranges of %1: leave the tag where it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Enter where the antenna of the tag is, then start.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate ranges of %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::RangeTexts</name>
    <message>
        <source>obstructed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>clear</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::ResultCard</name>
    <message>
        <source>Turn aborted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Turn failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The AGV may still be moving: the connection was lost while its wheels were turning. Go and look before you start again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The wheels have been set to zero. Press Calibrate to start again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo: sleeptime %1 again</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::ResultText</name>
    <message>
        <source>Position found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Two positions are possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position found, please check</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No position found</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reads of this turn do not tell where %1 stands.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 stands at x %2, y %3 and faces %4. With 95 % certainty within ±%5 and ±%6.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Solver status: %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The uncertainty is too large for driving. Repeat the turn with a longer dwell.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A second position explains the reads nearly as well: x %1, y %2, facing %3 (dashed on the map). Look which one is right, or repeat the turn with 12 or 16 stops.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>A second position explains the reads nearly as well. Repeat the turn with 12 or 16 stops.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too few tags were read. Is the AGV on the tag field, and the reader powered?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The AGV turned against the commanded direction. Check that its wheels are not swapped.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The steps differ more than usual. Check the wheels for slip and the battery.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reads contradict the plant file. Check the floor tags and the RSSI table.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No tag was read. Check the RFID reader&apos;s link and that the AGV stands on the tag field.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The computation ran out of its budget. Repeat the turn.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The steps were %1 instead of %2: a sleeptime of %3 fits (±%4).</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x %1, y %2, facing %3 (95 %: ±%4, ±%5)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So far: %1; a second position is still possible</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>So far: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::SerialPortDialog</name>
    <message>
        <source>trek (TREK1000, firmware 2.x)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trek-1.06 (TREK1000, firmware 1.06)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ulm4 (ULM1, LD600)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ulm8 (ULM3)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>esp32 (as trek, without a time)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>imu (metres, motion sensors)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>found from what the unit writes</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Ask the unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Use this port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port of the UWB unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;List again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look again which serial ports this computer has</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close; the port stays as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Or another &amp;path</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Dialect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Any name the system opens; a choice in the list fills it in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How the unit writes its reports; choose one only when it is found wrongly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ask the unit for its version, number and radio channel</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Use this port and dialect from now on; Undo takes it back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Device</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB ID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>any</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The first TREK1000 unit that is plugged in</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unit is not connected: choose its port, then open it in the panel Links.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unit has not told yet what it is.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit: %1, number %2, channel %3, %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>6.81 Mb/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>110 kb/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This computer has no serial port now. Plug the unit in, then list again.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::ShiftLog</name>
    <message>
        <source>Sleeptime changed from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel speed of its turns changed from %1 to %2</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::ShiftPanel</name>
    <message>
        <source>%1 (%2)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of shift: all %1 checks passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of shift: %1 of %2 checks failed: %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Before the shift: press the button above. Nothing moves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All %1 checks passed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 checks failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ready: all AGVs (%1) were located in %2.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Located in %2: AGV %1. The others could not be calibrated.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not ready: no AGV was located.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not ready: located was only AGV %1.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Start of shift: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turns …</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>stopped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>did not start; the event log says why</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate one after the &amp;other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate AGV %1 one after the &amp;other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All AGVs (%1) were located in %2, but %3 of the checks failed.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::ShortcutDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop all AGVs, from everywhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Arrows, +, -</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move and zoom the map that has the focus</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Copy the chosen lines of the event log</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go to the next field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Choose AGV 1 to 9</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Close</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::StopFitPlot</name>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Floor tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>missed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>out of place</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No stops to compare yet. Press Calibrate: after the third stop this shows which tags each stop saw, missed or should not have seen.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::UwbEditor</name>
    <message>
        <source>Choose port %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::gui::UwbScreens</name>
    <message>
        <source>All 256 anchor numbers are in use.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All 256 tag numbers are in use.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to undo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No UWB anchors, so UWB is not used. Add them here, or import a list of this or another program.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No UWB tags. Add the anchors first (panel UWB anchors), then tags; those that are heard come by themselves.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No UWB tags: none is listed, and none is heard. Switch a tag on, or add one here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No UWB tags: none is listed. Open the UWB unit in the panel Links and switch a tag on; it comes by itself. Or add one here.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Import anchors and tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor lists and plant files (*.csv *.xml *.json *.cfg *.txt)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor list (*.csv)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Imported: anchors %1, tags %2. Undo takes the import back.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unsaved edits</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The UWB anchors and tags were edited but not saved to the plant file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Save and close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&amp;Discard and close</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go &amp;back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In use, but not saved: lost when the console ends.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>In use until the console ends: this plant has no file. Export keeps the anchors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Export anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchors of DecaRangeRTLS (*.xml)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::AlarmTableModel</name>
    <message>
        <source>%1 (%2 times)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Priority</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What is the matter, and what to do</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::AlarmWords</name>
    <message>
        <source>Low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Medium</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>High</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Held back</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>New</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Acknowledged</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Over, new</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shelved, %1 left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plant</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It may be moving: its connection was lost while the wheels were turning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot reports an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No robot can connect</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection to the robot is disturbed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection to the RFID reader is disturbed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection to the UWB unit is disturbed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its position is doubted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The battery is low</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The anchor does not seem to stand where the list says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing has been measured for some way: the position is only predicted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 floor tags that the last turn should have read were not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The last turn read floor tags that the plant file does not name: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 tried to connect and was refused</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Go and look; use the switch of the AGV.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at the display of the AGV; switch it off and on again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the other program that uses the port, or change the port in the plant file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is the AGV switched on and in reach of the Wi-Fi?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Has the WeMos bridge power and Wi-Fi? It is tried again by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is the UWB unit plugged in and in its report mode?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Calibrate the AGV again before it drives.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charge it soon; until then it turns more slowly than its sleeptime expects.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put the anchor back, or enter its new place in the list of anchors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Drive slowly over floor tags, or calibrate again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map marks them with crossed squares: are they there, and whole?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The map marks them with question marks: add them to the plant file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>If it is an AGV of this plant, enter its address in the plant file; else find out whose it is.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::AnchorTableModel</name>
    <message>
        <source>Anchor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of the last %1 ranges of %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No range of %1 yet: open the UWB unit and switch a tag on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too few ranges of %1 with a position yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is an anchor %1 already (%2): choose another number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 of %2 in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Renumber %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No.</source>
        <comment>number of an anchor</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the anchor, as in the reports: 0 to 255</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name on the map and in messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Antenna of the anchor, to the east of the plant&apos;s origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Antenna of the anchor, to the north of the plant&apos;s origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the anchor&apos;s antenna above the floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Map</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Whether the map shows the anchor; its ranges are used in any case</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Age</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time since the last range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ranges per second, of all tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Residual (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>How much longer its ranges are than the distances to the positions, on average. Far from 0: it stands elsewhere, its view is blocked, or its ranges need a correction</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation of the residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Notice</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Why the place of the anchor in the list is doubted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate (1/s)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::CellInput</name>
    <message>
        <source>&quot;%1&quot; is not a number: %2 stays as it was.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range: %2 may be from %3 to %4.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number: %2 stays as it was.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::CorrectionTableModel</name>
    <message>
        <source>%1 – %2</source>
        <comment>anchor and tag</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: added to each measured range, in cm; empty: nothing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the correction %1 in cm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Correct %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (cm)</source>
        <comment>correction of this tag</comment>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::EventTableModel</name>
    <message>
        <source>Time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Level</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Source</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (%2 times, last at %3)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::FloorTagTableModel</name>
    <message>
        <source>Not read</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read now</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read before</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Missing</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Short</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Read by</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RSSI, steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last read</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::LinkTableModel</name>
    <message>
        <source>AGV %1 RFID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1 robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Address: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Received: %1 messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dropped: none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dropped: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages that could not be used; hover a row for the reasons</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connection</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>in %1</source>
        <comment>time until the next try</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 ago</source>
        <comment>age of the last message</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Messages per second, and the age of the last one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate, age</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dialect: %1, as the plant file says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Dialect: %1, found from the reports</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Unit: %1, number %2, channel %3, %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>6.81 Mb/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>110 kb/s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Exchanges missed: %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::Messages</name>
    <message>
        <source>Listening for robots on %1 (TCP), %2 (UDP)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Listening for robots on %1 (TCP), no telemetry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (TCP), no telemetry</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not listening yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not listening: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All AGVs were told to stop: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop all was pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The operator aborted it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The console ends</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 tried to connect as a robot and was refused: it is not in the plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no AGV %1 in the plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The initialisation turn was not started: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Initialisation turn started</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a turn is running</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot is not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the RFID reader is not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot is docked: undock it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot is in error: look at the robot, then switch it off and on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no finished turn</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop %1 is not read again: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sleeptime was not changed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot connected a second time from %1; its older connection was closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot connected anew, it may have restarted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot connected from %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>THE ROBOT MAY STILL BE MOVING: its link was lost while it drove. Use its own switch. (%1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link to the robot was lost: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link to the RFID reader was lost: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it was closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a command could not be sent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 more messages were left out</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is docking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is docking to charge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is docked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is undocking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is idle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is in error: look at the robot, then switch it off and on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot&apos;s program failed at %1, line %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected, but nothing heard for 5 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for the robot to connect: switch it on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop %1 is read again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No floor tag was read for %1 s: check the RFID reader and that the AGV stands on tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No floor tag was read at stop %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot did not report the end of its turn in time: check that its wheels are free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The solver gave no answer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot reports an error: look at the robot, then switch it off and on</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is docking or docked: undock it first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot stopped in the middle of a turn: look for what it bumped into</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot was stopped %1 ms late: this computer was busy, the step is about %2 degrees too long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of stops is %1: it must be 8, 12 or 16</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is %2: it must lie between %3 and %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel speed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Shortest dwell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Longest dwell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected again, but still nothing is heard: no floor tag below the antenna, or the reader has no power</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer within %1 s: check the address and that the device has power and Wi-Fi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected, but nothing heard for %1 s: no floor tag below the antenna, or the link is dead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing heard for %1 s: the connection is being made anew</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 refuses the connection: the device is on, but nothing listens on that port; check the port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 closed the connection: it was switched off, restarted or serves other clients already</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 closed the connection: it was switched off or restarted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The host &quot;%1&quot; is not known: check the name in the plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 no longer answers: check its power and its Wi-Fi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not answer: check the address, its power and its Wi-Fi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be reached (%2): check the cable, the Wi-Fi and the address</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The system forbids a connection to %1: check the firewall</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connection to %1 failed: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is in use: another console or program holds it; end that program or change the port in the plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is forbidden by the system: ports below 1024 need administrator rights; choose a higher port in the plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 does not exist: this computer has no network interface with that address; check the listen address in the plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 port %2 on %3</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address: the listen address of the plant file must be one of this computer, such as 127.0.0.1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated plant could not be started: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated plant ended unexpectedly (exit status %1)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The simulated plant was ended by signal %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Console</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RFID reader %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 unknown type</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 unknown message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bad length</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bad value</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 empty</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 noise</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bad UID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bad RSSI</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 truncated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 trailing text</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 over-long</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bad tag count</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 sent telemetry that was ignored: the plant file has no robot with that address, or more than one</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is driving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is driving a segment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is waiting for a segment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The wheel speed was not changed: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Sleeptime %1 ms is written to %2; there it was %3 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The sleeptime holds for this session only: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the plant is simulated</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>there is no plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected again, but still nothing is heard: no UWB tag is switched on or in reach, or the unit hangs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Connected, but nothing heard for %1 s: no UWB tag is switched on or in reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No answer within %1 s: unplug the unit and plug it in again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The port is not the one of a TREK1000 unit (USB id 0483:5740): nothing is sent to it unless you ask for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The reports are those of a clone (%1): nothing is sent to it unless you ask for it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unit did not tell its version and configuration: the age of its ranges is measured from its reports instead</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The unit is %1: %2 %3, channel %4, %5</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>anchor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>listener</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not heard for %1 s: the tag is off or out of reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor %1 measures this tag, but is not in the plant file: enter where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor %1 is not in the list: enter its height to have it placed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor %1 has no ranges to the others and stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor %1 has too few ranges to the others to be placed and stays where it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>More than one arrangement fits the ranges and the one nearest to the list was taken: look whether it is right, the range between anchors %1 and %2 would tell</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The range between anchors %1 and %2 is %3 mm too long: look for what stands between them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The range between anchors %1 and %2 is %3 mm too short: look for what stands between them</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The range between anchors %1 and %2 (%3 mm) is shorter than the difference of their heights (%4 mm): correct the heights in the list</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no anchor in the list: enter the anchors with their heights first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No ranges between the anchors were heard: switch the anchors on and connect the unit that is anchor 0</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too few pairs of anchors range with each other: three anchors that all see each other are needed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The anchors stand nearly on one line: their ranges do not tell how far beside it; move one of them aside</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ranges between the anchors fit no arrangement: look for what hides the anchors from each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Only %1 of the 3 ranges that a position needs: look for what hides the anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ranges fit no position: check the anchors&apos; places in the plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no anchor in the list: enter where the anchors are</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The place of the tag is not known: enter where it stands</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The time of a calibration must lie between %1 and %2 s: choose another</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No anchor measured tag %1 %2 times: bring it nearer to the anchors or take longer</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag %1 was not heard: switch it on and look whether the anchors are in reach</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ranges of anchor %1 are wrong by %2 mm: check the places of the tag and the anchor before you use the offset</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The ranges of anchor %1 scatter by %2 mm: look for what hides it, keep the tag still and calibrate again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchors without an offset, because they measured the tag fewer than %1 times: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The anchors were changed meanwhile: start the calibration again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ranges fit a place %1 mm from the one in the list: measure the anchor again or restore it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ranges are %1 mm too long: the anchor may have been moved or be hidden; look at it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ranges are %1 mm too short: the anchor may have been moved; measure it again or calibrate its ranges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor %1: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no serial port %1: plug the unit in, or choose another port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial port %1 is in use: another console, terminal or program holds it; end that program</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You may not open the serial port %1: install the udev rule %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>You may not open the serial port %1: join the group %2 (sudo usermod -aG %3 $USER, then log in anew) or install the udev rule %4</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 is no serial port: choose another port</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial port %1 is gone: the unit was unplugged or lost its power; plug it in again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Serial port %1 failed: %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>USB %1, serial number %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 bad field</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left out: %1 more</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The file has no heights: the new tags have %1 mm until you enter their own</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchors and the corrections of the tags 0 to 7 are written to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchors are written to %1; tags and corrections have no place in that format</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its pose is doubted. %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The floor tags it reads lie elsewhere: it was moved or slipped; calibrate it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Its UWB tag is elsewhere: it was moved; calibrate it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It drove by itself to dock or undock: calibrate it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The link to the robot was lost while it drove: calibrate it again</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing measured for the last %1 mm of its way: the pose is what the commanded speeds make of it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was told to stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It was told to %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does not drive: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does not dock: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does not undock: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It does not dock to charge: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Driving by hand ended: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Driven by hand, with the keys</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Driven by hand, with the pad</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop was pressed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>undock</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>dock to charge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the operator let go</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the keyboard went elsewhere</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the drive pad is no longer to be seen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>a dialog opened over the window</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>another AGV was chosen</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the keys cancelled each other</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the window did not react for a moment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the screen was locked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>this computer or this program was put to sleep</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>no word came from the operator&apos;s hand for 250 ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot did not confirm a command for 250 ms: check its Wi-Fi</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the link to the robot was lost</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the robot docks or undocks by itself: wait, or press Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop all was pressed: look that the way is free, then release it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is driven from elsewhere: mouse and keys do not drive together</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>it is driven by hand: let go first</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the speed is zero</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::PlotFeed</name>
    <message>
        <source>Position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Heading error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position uncertainty, 95 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB ranges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB residuals</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RSSI of floor tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wheel speeds</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery charge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery voltage</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Message rates</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Age of the last message</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>steps</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag %1, anchor %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1 left</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1 right</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1 RFID</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1 robot</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::RangeCalibrationModel</name>
    <message>
        <source>Anchor %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too few ranges: its correction stays as it is</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Standard deviation of a single range</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Anchor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Found (cm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Spread (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Now (cm)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::ShiftChecks</name>
    <message>
        <source>Plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It holds no floor tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add them to the plant file and start again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It names no AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Add one to the plant file and start again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1: %2 floor tags, %3 AGVs</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Port for robots</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>End the other program that uses the port, or change the port in the plant file.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1: robot</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Switch the AGV on; it connects by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It reports an error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Look at its display; switch it off and on again.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1: battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It has not reported its charge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Wait until the robot is connected.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charge it; a shift takes %1 or more.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1: RFID reader</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It is closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Press Open RFID.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Push the AGV a little, so that its antenna is over a floor tag.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Has the WeMos bridge power and Wi-Fi? It is tried again by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Nothing was read for %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1: floor tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It reads none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>It reads tag %1, which the plant file does not name</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Is this the plant file of this plant? Else add the tag to it.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>What it reads is in the plant file</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1: sleeptime</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 for wheels at %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>For its track about %1 is expected: correct the sleeptime, then calibrate.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Plug the unit in and choose its serial port in the menu UWB.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>UWB anchors</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not heard: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Have they power, and is a tag switched on?</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not where the list says: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Put them back, or enter their new places in the list of anchors.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>All %1 are heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Disk</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Make room: %1 or more.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::StatisticsTableModel</name>
    <message>
        <source>Of the magnitudes: of a position error the circular errors CE50, CE75, CE95</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Of an error: the bias</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Share of the time with a value not older than 1 s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Curve</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>At the cursor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Values</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Mean</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Std. dev.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RMS</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Median</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>50 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>75 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 %</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Largest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Available</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::StopTableModel</name>
    <message>
        <source>Tag %1, RSSI %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop %1: %2 reads of %3 tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Expected but not seen: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not in the plant file: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Belongs elsewhere: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Stop</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reads</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>RSSI %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag %1</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::UwbTagTableModel</name>
    <message>
        <source>UWB tag %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not heard</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fix</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not listed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No range to %1 in the last report</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not used: the range to %1 does not fit the others, its view is probably blocked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Measured minus expected: %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Range to %1, corrected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No report of this tag yet: switch it on and open the UWB unit</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>This tag is heard but is not in the list: an entry of a label, an AGV or a height lists it</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Too few positions yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 reports, %2 exchanges missed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is no AGV &quot;%1&quot;: choose one of the plant for %2, or none.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the height of %1 in mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>the number of %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>There is a UWB tag %1 already (%2): choose another number.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>List %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No.</source>
        <comment>number of a UWB tag</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Number of the tag, as in the reports: 0 to 255</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Name on the map and in messages</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The AGV that carries the tag</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Height of the tag&apos;s antenna above the floor</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>x (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the tag&apos;s antenna, to the east of the plant&apos;s origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>y (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Position of the tag&apos;s antenna, to the north of the plant&apos;s origin</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>95 % (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The position lies within this of x and y with 95 % certainty, for anchors that stand where the list says</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Age</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Time since the ranges were measured</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Reports per second</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>R95 (mm)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Repeatability: 95 % of the last positions lie within this of their own mean. It says nothing of how far that mean is from the truth</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Fix: there is a position; else the reason why there is none</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>%1 (mm)</source>
        <comment>range to this anchor</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Last range to %1, corrected. A cross marks a range that is not used</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Rate (1/s)</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::VehicleTableModel</name>
    <message>
        <source>AGV %1</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>May be moving</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The connection was lost while the wheels were turning. Go and look before you drive.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery: %1, %2</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Temperature: %1 °C</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot has not connected. Switch it on; it connects by itself.</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>AGV</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Battery</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Charge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>The robot is connected but has not reported its battery yet.</source>
        <translation type="unfinished"></translation>
    </message>
</context>
<context>
    <name>agv::model::Words</name>
    <message>
        <source>mm</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Closed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Opening</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Up</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Silent</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Failed</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Idle</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Driving a segment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Waiting for a segment</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Driving directly</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Docking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Docked</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Undocking</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Docking (demo)</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Error</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>not charging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reconditioning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>trickle charging</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>waiting to charge</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>charging fault</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Info</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Warning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>No turn yet</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>coming to rest</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>reading tags</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>turning</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Computing the position</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Finished</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Aborted</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>ms</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>s</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>min</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>/s</source>
        <comment>per second</comment>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>V</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Detail</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>State unknown</source>
        <translation type="unfinished"></translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation type="unfinished"></translation>
    </message>
</context>
</TS>
