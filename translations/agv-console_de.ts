<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="de_DE">
<context>
    <name>AlarmPanel</name>
    <message>
        <source>&amp;Acknowledge</source>
        <translation>&amp;Quittieren</translation>
    </message>
    <message>
        <source>You know of the chosen alarms; with none chosen, of all that are new</source>
        <translation>Sie kennen die gewählten Alarme; ist keiner gewählt, alle neuen</translation>
    </message>
    <message>
        <source>S&amp;helve</source>
        <translation>&amp;Zurückstellen</translation>
    </message>
    <message>
        <source>Put the chosen alarms aside for a while; not those of high priority</source>
        <translation>Die gewählten Alarme für eine Weile beiseitelegen; nicht die von hoher Priorität</translation>
    </message>
    <message>
        <source>&amp;Bring back</source>
        <translation>Zurück&amp;holen</translation>
    </message>
    <message>
        <source>Take the chosen alarms off the shelf</source>
        <translation>Die gewählten Alarme zurückholen</translation>
    </message>
    <message>
        <source>Sound</source>
        <translation>Ton</translation>
    </message>
    <message>
        <source>A short sound for every new alarm</source>
        <translation>Ein kurzer Ton bei jedem neuen Alarm</translation>
    </message>
    <message>
        <source>Many alarms at once: those of low priority are held back until it is quieter.</source>
        <translation>Viele Alarme auf einmal: Die von niedriger Priorität warten, bis es ruhiger ist.</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
</context>
<context>
    <name>CalibrationPanel</name>
    <message>
        <source>A&amp;GV</source>
        <translation>A&amp;GV</translation>
    </message>
    <message>
        <source>The AGV to calibrate</source>
        <translation>Das AGV, das kalibriert werden soll</translation>
    </message>
    <message>
        <source>Slee&amp;ptime</source>
        <translation>Slee&amp;ptime</translation>
    </message>
    <message>
        <source>Time of a 45 degree turn. About 1,125 ms with a charged battery, more when it is weak.</source>
        <translation>Dauer einer Drehung um 45 Grad. Etwa 1.125 ms mit geladener Batterie, mehr, wenn sie schwach ist.</translation>
    </message>
    <message>
        <source> ms</source>
        <translation> ms</translation>
    </message>
    <message>
        <source>Timed: each step ends after the sleeptime. Measured: the robot ends each step by its wheel encoders.</source>
        <translation>Nach Zeit: Jeder Schritt endet nach der Sleeptime. Gemessen: Der Roboter beendet jeden Schritt nach seinen Radgebern.</translation>
    </message>
    <message>
        <source>Timed</source>
        <translation>Nach Zeit</translation>
    </message>
    <message>
        <source>Measured</source>
        <translation>Gemessen</translation>
    </message>
    <message>
        <source>&amp;Direction</source>
        <translation>Ri&amp;chtung</translation>
    </message>
    <message>
        <source>Direction of the turn, seen from above</source>
        <translation>Drehrichtung, von oben gesehen</translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation>Gegen Uhrzeiger</translation>
    </message>
    <message>
        <source>Clockwise</source>
        <translation>Im Uhrzeigersinn</translation>
    </message>
    <message>
        <source>S&amp;tops</source>
        <translation>S&amp;topps</translation>
    </message>
    <message>
        <source>Stops in one full turn; a closing reading follows</source>
        <translation>Stopps einer vollen Drehung; eine abschließende Lesung folgt</translation>
    </message>
    <message>
        <source>D&amp;well</source>
        <translation>Ver&amp;weilen</translation>
    </message>
    <message>
        <source>Longest time at a stop</source>
        <translation>Längste Zeit an einem Stopp</translation>
    </message>
    <message>
        <source>&amp;Calibrate (Initialization)</source>
        <translation>&amp;Kalibrieren (Initialisierung)</translation>
    </message>
    <message>
        <source>A&amp;bort</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>Stop this turn; the wheels are set to zero</source>
        <translation>Diese Drehung anhalten; die Räder werden auf null gesetzt</translation>
    </message>
    <message>
        <source>Progress of the turn</source>
        <translation>Fortschritt der Drehung</translation>
    </message>
    <message>
        <source>Table of stops</source>
        <translation>Tabelle der Stopps</translation>
    </message>
    <message>
        <source>&amp;Read this stop again</source>
        <translation>St&amp;opp neu lesen</translation>
    </message>
    <message>
        <source>The AGV turns back to the chosen stop and reads it once more</source>
        <translation>Das AGV dreht zum gewählten Stopp zurück und liest ihn noch einmal</translation>
    </message>
    <message>
        <source>Copy table</source>
        <translation>Tabelle kopieren</translation>
    </message>
    <message>
        <source>Copy the whole table as text</source>
        <translation>Die ganze Tabelle als Text kopieren</translation>
    </message>
    <message>
        <source>Fit of each stop</source>
        <translation>Güte der Stopps</translation>
    </message>
    <message>
        <source>T&amp;urn</source>
        <translation>&amp;Drehung</translation>
    </message>
    <message>
        <source>Initialization turn: the AGV turns once on the spot, reads the floor tags at every stop and finds where it stands</source>
        <translation>Initialisierungsdrehung: Das AGV dreht sich einmal auf der Stelle, liest an jedem Stopp die Bodentags und findet heraus, wo es steht</translation>
    </message>
    <message>
        <source>Details of the turn</source>
        <translation>Einzelheiten der Drehung</translation>
    </message>
    <message>
        <source>Speed of the wheels while the AGV turns. A new speed scales the sleeptime: half the speed takes twice the time.</source>
        <translation>Geschwindigkeit der Räder, während sich das AGV dreht. Eine neue Geschwindigkeit ändert die Sleeptime mit: Das halbe Tempo braucht die doppelte Zeit.</translation>
    </message>
    <message>
        <source> mm/s</source>
        <translation> mm/s</translation>
    </message>
    <message>
        <source>&amp;Leave stable stops early</source>
        <translation>Bei stab&amp;ilen Tags weiter</translation>
    </message>
    <message>
        <source>A stop ends as soon as its tags are stable; off: every stop takes the whole dwell</source>
        <translation>Ein Stopp endet, sobald seine Tags stabil sind; aus: Jeder Stopp dauert die volle Verweilzeit</translation>
    </message>
    <message>
        <source>What the stops read so far say; the final result comes after the last one</source>
        <translation>Was die bisher gelesenen Stopps sagen; das endgültige Ergebnis kommt nach dem letzten</translation>
    </message>
    <message>
        <source>Whe&amp;el speed</source>
        <translation>&amp;Radtempo</translation>
    </message>
</context>
<context>
    <name>EventPanel</name>
    <message>
        <source>Event log</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>Kopieren</translation>
    </message>
    <message>
        <source>Copy the chosen lines, or all when none is chosen</source>
        <translation>Die gewählten Zeilen kopieren, oder alle, wenn keine gewählt ist</translation>
    </message>
    <message>
        <source>Details</source>
        <translation>Einzelheiten</translation>
    </message>
    <message>
        <source>Show also what follows from the console&apos;s own commands, such as every start and stop of a robot</source>
        <translation>Auch zeigen, was aus den Befehlen der Konsole selbst folgt, etwa jedes Anfahren und Anhalten eines Roboters</translation>
    </message>
</context>
<context>
    <name>FloorTagPanel</name>
    <message>
        <source>Number, UID or AGV</source>
        <translation>Nummer, UID oder AGV</translation>
    </message>
    <message>
        <source>Filter of the floor tags</source>
        <translation>Filter der Bodentags</translation>
    </message>
    <message>
        <source>Show only tags whose number, UID or reader&apos;s AGV holds this text</source>
        <translation>Nur Tags zeigen, deren Nummer, UID oder lesendes AGV diesen Text enthält</translation>
    </message>
    <message>
        <source>State of the floor tags</source>
        <translation>Zustand der Bodentags</translation>
    </message>
    <message>
        <source>Show only tags in this state</source>
        <translation>Nur Tags in diesem Zustand zeigen</translation>
    </message>
    <message>
        <source>C&amp;olumns</source>
        <translation>S&amp;palten</translation>
    </message>
    <message>
        <source>Choose the columns; also by the right mouse button on the heads</source>
        <translation>Die Spalten wählen; auch mit der rechten Maustaste auf den Köpfen</translation>
    </message>
    <message>
        <source>Copy as CS&amp;V</source>
        <translation>Als CS&amp;V kopieren</translation>
    </message>
    <message>
        <source>Copy the rows in sight, in their order</source>
        <translation>Die sichtbaren Zeilen in ihrer Reihenfolge kopieren</translation>
    </message>
    <message>
        <source>Floor tags</source>
        <translation>Bodentags</translation>
    </message>
    <message>
        <source>Double click or Enter shows the tag on the map</source>
        <translation>Doppelklick oder Eingabe zeigt den Tag auf der Karte</translation>
    </message>
</context>
<context>
    <name>JogPanel</name>
    <message>
        <source>AGV</source>
        <translation>AGV</translation>
    </message>
    <message>
        <source>The AGV to drive</source>
        <translation>Das AGV, das gefahren wird</translation>
    </message>
    <message>
        <source>F&amp;ine</source>
        <translation>Fe&amp;in</translation>
    </message>
    <message>
        <source>A fifth of the speed, to place the AGV exactly</source>
        <translation>Ein Fünftel der Geschwindigkeit, um das AGV genau hinzustellen</translation>
    </message>
    <message>
        <source>Speed</source>
        <translation>Geschwindigkeit</translation>
    </message>
    <message>
        <source>Speed of the faster wheel</source>
        <translation>Geschwindigkeit des schnelleren Rades</translation>
    </message>
    <message>
        <source>Speed of the faster wheel. Hands never drive faster than 250 mm/s, nor than the plant file allows this AGV.</source>
        <translation>Geschwindigkeit des schnelleren Rades. Von Hand wird nie schneller als 250 mm/s gefahren und nie schneller, als die Anlagendatei diesem AGV erlaubt.</translation>
    </message>
    <message>
        <source>Stop all was pressed. No AGV can be driven by hand until you release it. Look that the way is free.</source>
        <translation>„Alle anhalten“ wurde gedrückt. Kein AGV lässt sich von Hand fahren, bis Sie es freigeben. Prüfen Sie, ob der Weg frei ist.</translation>
    </message>
    <message>
        <source>Release</source>
        <translation>Freigeben</translation>
    </message>
    <message>
        <source>Let hands drive again after Stop all, with a fresh press</source>
        <translation>Handfahrt nach „Alle anhalten“ wieder erlauben, mit neuem Drücken</translation>
    </message>
    <message>
        <source>Keys: W A S D or the arrow keys, two at once for a curve; space stops this AGV. They work only while the pad has the keyboard (blue frame): click it or press Ctrl+J.</source>
        <translation>Tasten: W A S D oder die Pfeiltasten, zwei zugleich für eine Kurve; die Leertaste hält dieses AGV an. Sie wirken nur, solange das Fahrfeld die Tastatur hat (blauer Rahmen): anklicken oder Strg+J drücken.</translation>
    </message>
    <message>
        <source>Dock</source>
        <translation>Andocken</translation>
    </message>
    <message>
        <source>The AGV drives into its dock by itself</source>
        <translation>Das AGV fährt selbst in seine Ladestation</translation>
    </message>
    <message>
        <source>Undock</source>
        <translation>Abdocken</translation>
    </message>
    <message>
        <source>The AGV leaves its dock by itself, backwards</source>
        <translation>Das AGV verlässt seine Ladestation selbst, rückwärts</translation>
    </message>
    <message>
        <source>Charge</source>
        <translation>Laden</translation>
    </message>
    <message>
        <source>The base of the AGV looks for its dock by itself, to charge</source>
        <translation>Das Fahrgestell des AGV sucht seine Ladestation selbst, um zu laden</translation>
    </message>
    <message>
        <source>If the Wi-Fi fails, an AGV may drive on with its last speed: keep the switch on the AGV in reach.</source>
        <translation>Fällt das WLAN aus, fährt ein AGV vielleicht mit seiner letzten Geschwindigkeit weiter: den Schalter am AGV in Reichweite behalten.</translation>
    </message>
</context>
<context>
    <name>LinksPanel</name>
    <message>
        <source>&amp;Open RFID</source>
        <translation>RFID ö&amp;ffnen</translation>
    </message>
    <message>
        <source>Open the RFID reader of the chosen row; with none chosen, all readers</source>
        <translation>Den RFID-Leser der gewählten Zeile öffnen; ist keine gewählt, alle Leser</translation>
    </message>
    <message>
        <source>&amp;Close RFID</source>
        <translation>RFID schli&amp;eßen</translation>
    </message>
    <message>
        <source>Close the RFID reader of the chosen row; with none chosen, all readers</source>
        <translation>Den RFID-Leser der gewählten Zeile schließen; ist keine gewählt, alle Leser</translation>
    </message>
    <message>
        <source>Connections</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>AGVs</source>
        <translation>AGVs</translation>
    </message>
    <message>
        <source>&amp;Read RFID</source>
        <translation>RFID &amp;lesen</translation>
    </message>
    <message>
        <source>Show which floor tags the reader of the chosen row reads now; opens it when it is closed. With none chosen, all readers</source>
        <translation>Zeigt, welche Bodentags der Leser der gewählten Zeile gerade liest; öffnet ihn, wenn er geschlossen ist. Ohne Auswahl alle Leser</translation>
    </message>
    <message>
        <source>Floor tags read now</source>
        <translation>Gerade gelesene Bodentags</translation>
    </message>
    <message>
        <source>&amp;Port…</source>
        <translation>&amp;Port…</translation>
    </message>
    <message>
        <source>Choose the serial port of the UWB unit, and how the unit writes</source>
        <translation>Den seriellen Port der UWB-Einheit wählen, und wie sie schreibt</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>AGV Console</source>
        <translation>AGV-Leitstand</translation>
    </message>
    <message>
        <source>SIMULATION: no real AGV is connected</source>
        <translation>SIMULATION: Es ist kein echtes AGV verbunden</translation>
    </message>
    <message>
        <source>&amp;File</source>
        <translation>&amp;Datei</translation>
    </message>
    <message>
        <source>&amp;AGV</source>
        <translation>AG&amp;V</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>&amp;Ansicht</translation>
    </message>
    <message>
        <source>&amp;Appearance</source>
        <translation>&amp;Erscheinungsbild</translation>
    </message>
    <message>
        <source>&amp;Panels</source>
        <translation>&amp;Fenster</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>&amp;Hilfe</translation>
    </message>
    <message>
        <source>Tool bar</source>
        <translation>Werkzeugleiste</translation>
    </message>
    <message>
        <source>Links</source>
        <translation>Verbindungen</translation>
    </message>
    <message>
        <source>Calibration</source>
        <translation>Kalibrierung</translation>
    </message>
    <message>
        <source>Event log</source>
        <translation>Ereignisse</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Close the console; every robot is stopped first</source>
        <translation>Den Leitstand schließen; vorher wird jeder Roboter angehalten</translation>
    </message>
    <message>
        <source>&amp;Calibrate (Initialization)</source>
        <translation>&amp;Kalibrieren (Initialisierung)</translation>
    </message>
    <message>
        <source>Turn the chosen AGV once on the spot and find where it stands</source>
        <translation>Das gewählte AGV einmal drehen und seine Position bestimmen</translation>
    </message>
    <message>
        <source>&amp;Abort turn</source>
        <translation>Drehung &amp;abbrechen</translation>
    </message>
    <message>
        <source>Stop the running turn of the chosen AGV</source>
        <translation>Die laufende Drehung des gewählten AGV anhalten</translation>
    </message>
    <message>
        <source>&amp;Stop all</source>
        <translation>Alle an&amp;halten</translation>
    </message>
    <message>
        <source>Stops all AGVs at once (Esc or Pause). Software stop, does not replace the emergency stop.</source>
        <translation>Hält alle AGVs sofort an (Esc oder Pause). Software-Halt, ersetzt nicht den Not-Halt.</translation>
    </message>
    <message>
        <source>&amp;Whole plant</source>
        <translation>&amp;Ganze Anlage</translation>
    </message>
    <message>
        <source>Show the whole plant</source>
        <translation>Die ganze Anlage zeigen</translation>
    </message>
    <message>
        <source>Zoom &amp;in</source>
        <translation>Ver&amp;größern</translation>
    </message>
    <message>
        <source>Zoom in; the mouse wheel zooms to the pointer</source>
        <translation>Vergrößern; das Mausrad zoomt zum Zeiger</translation>
    </message>
    <message>
        <source>Zoom &amp;out</source>
        <translation>Ver&amp;kleinern</translation>
    </message>
    <message>
        <source>Zoom out</source>
        <translation>Verkleinern</translation>
    </message>
    <message>
        <source>&amp;Chosen AGV</source>
        <translation>Ge&amp;wähltes AGV</translation>
    </message>
    <message>
        <source>Show the chosen AGV large</source>
        <translation>Das gewählte AGV groß zeigen</translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation>&amp;Folgen</translation>
    </message>
    <message>
        <source>Keep the chosen AGV in the middle of the map</source>
        <translation>Das gewählte AGV in der Mitte der Karte halten</translation>
    </message>
    <message>
        <source>Show &amp;grid</source>
        <translation>&amp;Raster zeigen</translation>
    </message>
    <message>
        <source>Show floor &amp;tags</source>
        <translation>Boden&amp;tags zeigen</translation>
    </message>
    <message>
        <source>Show &amp;stations</source>
        <translation>&amp;Stationen zeigen</translation>
    </message>
    <message>
        <source>As the &amp;desktop</source>
        <translation>Wie der &amp;Desktop</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>&amp;Hell</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>&amp;Dunkel</translation>
    </message>
    <message>
        <source>&amp;Reset layout</source>
        <translation>Anordnung &amp;zurücksetzen</translation>
    </message>
    <message>
        <source>Put all panels back to their places</source>
        <translation>Alle Fenster an ihren Platz zurücksetzen</translation>
    </message>
    <message>
        <source>F&amp;ull screen</source>
        <translation>&amp;Vollbild</translation>
    </message>
    <message>
        <source>&amp;Keyboard shortcuts</source>
        <translation>&amp;Tastenkürzel</translation>
    </message>
    <message>
        <source>&amp;About AGV Console</source>
        <translation>&amp;Über den AGV-Leitstand</translation>
    </message>
    <message>
        <source>Stop all</source>
        <translation>Alle anhalten</translation>
    </message>
    <message>
        <source>What to do next</source>
        <translation>Nächster Schritt</translation>
    </message>
    <message>
        <source>C&amp;hoose</source>
        <translation>&amp;Wählen</translation>
    </message>
    <message>
        <source>Calibrate</source>
        <translation>Kalibrieren</translation>
    </message>
    <message>
        <source>&amp;Next panel</source>
        <translation>&amp;Nächstes Feld</translation>
    </message>
    <message>
        <source>Move the keyboard to the next panel</source>
        <translation>Mit der Tastatur ins nächste Feld gehen</translation>
    </message>
    <message>
        <source>&amp;Simulation</source>
        <translation>&amp;Simulation</translation>
    </message>
    <message>
        <source>Cut the RFID &amp;reader for 10 s</source>
        <translation>RFID-&amp;Leser 10 s abhängen</translation>
    </message>
    <message>
        <source>The reader of the chosen AGV loses its connection</source>
        <translation>Der Leser des gewählten AGV verliert seine Verbindung</translation>
    </message>
    <message>
        <source>Cut the r&amp;obot for 10 s</source>
        <translation>R&amp;oboter 10 s abhängen</translation>
    </message>
    <message>
        <source>The chosen AGV loses its connection and keeps its last speed</source>
        <translation>Das gewählte AGV verliert seine Verbindung und behält seine letzte Geschwindigkeit</translation>
    </message>
    <message>
        <source>Robot &amp;error</source>
        <translation>&amp;Fehler des Roboters</translation>
    </message>
    <message>
        <source>The chosen AGV reports an error</source>
        <translation>Das gewählte AGV meldet einen Fehler</translation>
    </message>
    <message>
        <source>&amp;Garbage from the RFID reader</source>
        <translation>&amp;Rauschen vom RFID-Leser</translation>
    </message>
    <message>
        <source>The reader of the chosen AGV prints 300 bytes of noise</source>
        <translation>Der Leser des gewählten AGV sendet 300 Bytes Rauschen</translation>
    </message>
    <message>
        <source>&amp;Weak battery (10 %)</source>
        <translation>Schwache &amp;Batterie (10 %)</translation>
    </message>
    <message>
        <source>The chosen AGV turns more slowly than its sleeptime expects</source>
        <translation>Das gewählte AGV dreht langsamer, als seine Sleeptime erwartet</translation>
    </message>
    <message>
        <source>20 &amp;dead floor tags</source>
        <translation>20 &amp;tote Bodentags</translation>
    </message>
    <message>
        <source>Floor tags anywhere never answer again</source>
        <translation>Irgendwelche Bodentags antworten nicht mehr</translation>
    </message>
    <message>
        <source>&amp;Undo all faults</source>
        <translation>Alle Störungen &amp;aufheben</translation>
    </message>
    <message>
        <source>Everything but the battery is as it was</source>
        <translation>Alles außer der Batterie ist wieder wie vorher</translation>
    </message>
    <message>
        <source>&amp;UWB</source>
        <translation>&amp;UWB</translation>
    </message>
    <message>
        <source>UWB anchors</source>
        <translation>UWB-Anker</translation>
    </message>
    <message>
        <source>UWB tags</source>
        <translation>UWB-Tags</translation>
    </message>
    <message>
        <source>&amp;Undo</source>
        <translation>&amp;Rückgängig</translation>
    </message>
    <message>
        <source>Take the last edit of the UWB kit back</source>
        <translation>Die letzte Änderung an der UWB-Anlage zurücknehmen</translation>
    </message>
    <message>
        <source>&amp;Redo</source>
        <translation>&amp;Wiederholen</translation>
    </message>
    <message>
        <source>Make the edit again that was taken back</source>
        <translation>Die zurückgenommene Änderung wieder vornehmen</translation>
    </message>
    <message>
        <source>&amp;Add anchor</source>
        <translation>&amp;Anker hinzufügen</translation>
    </message>
    <message>
        <source>Add an anchor with the lowest free number; then enter where it stands</source>
        <translation>Einen Anker mit der kleinsten freien Nummer hinzufügen; dann eintragen, wo er steht</translation>
    </message>
    <message>
        <source>Remove a&amp;nchors</source>
        <translation>A&amp;nker entfernen</translation>
    </message>
    <message>
        <source>Remove</source>
        <translation>Entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen anchors and their range corrections</source>
        <translation>Die gewählten Anker und ihre Abstandskorrekturen entfernen</translation>
    </message>
    <message>
        <source>Add &amp;tag</source>
        <translation>&amp;Tag hinzufügen</translation>
    </message>
    <message>
        <source>Add a tag with the lowest free number</source>
        <translation>Ein Tag mit der kleinsten freien Nummer hinzufügen</translation>
    </message>
    <message>
        <source>Remove ta&amp;gs</source>
        <translation>Ta&amp;gs entfernen</translation>
    </message>
    <message>
        <source>Remove the chosen tags from the list, and their range corrections</source>
        <translation>Die gewählten Tags und ihre Abstandskorrekturen aus der Liste entfernen</translation>
    </message>
    <message>
        <source>&amp;Place anchors…</source>
        <translation>Anker ein&amp;messen…</translation>
    </message>
    <message>
        <source>Find where the anchors stand from the ranges between them</source>
        <translation>Aus den Abständen der Anker untereinander finden, wo sie stehen</translation>
    </message>
    <message>
        <source>&amp;Calibrate ranges…</source>
        <translation>Abstände &amp;kalibrieren…</translation>
    </message>
    <message>
        <source>Find range corrections with a tag that stands at a known point</source>
        <translation>Abstandskorrekturen mit einem Tag finden, das an einem bekannten Punkt steht</translation>
    </message>
    <message>
        <source>C&amp;orrection table…</source>
        <translation>K&amp;orrekturtabelle…</translation>
    </message>
    <message>
        <source>Corrections…</source>
        <translation>Korrekturen…</translation>
    </message>
    <message>
        <source>What is added to the range of each tag to each anchor</source>
        <translation>Was zum Abstand jedes Tags von jedem Anker addiert wird</translation>
    </message>
    <message>
        <source>&amp;Import…</source>
        <translation>&amp;Importieren…</translation>
    </message>
    <message>
        <source>Replace anchors and tags by those of a file of this or another program</source>
        <translation>Anker und Tags durch die einer Datei dieses oder eines anderen Programms ersetzen</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>&amp;Exportieren…</translation>
    </message>
    <message>
        <source>&amp;Save to plant file</source>
        <translation>In Anlagendatei &amp;speichern</translation>
    </message>
    <message>
        <source>Write anchors, tags, corrections and port into the plant file</source>
        <translation>Anker, Tags, Korrekturen und Port in die Anlagendatei schreiben</translation>
    </message>
    <message>
        <source>Po&amp;rt…</source>
        <translation>Po&amp;rt…</translation>
    </message>
    <message>
        <source>Choose the serial port of the UWB unit, and how the unit writes</source>
        <translation>Den seriellen Port der UWB-Einheit wählen, und wie sie schreibt</translation>
    </message>
    <message>
        <source>Write the anchors to a file</source>
        <translation>Die Anker in eine Datei schreiben</translation>
    </message>
    <message>
        <source>&amp;Map</source>
        <translation>&amp;Karte</translation>
    </message>
    <message>
        <source>&amp;Layers</source>
        <translation>&amp;Ebenen</translation>
    </message>
    <message>
        <source>&amp;Trails</source>
        <translation>S&amp;puren</translation>
    </message>
    <message>
        <source>Show UWB &amp;anchors</source>
        <translation>UWB-&amp;Anker zeigen</translation>
    </message>
    <message>
        <source>Show &amp;UWB tags</source>
        <translation>&amp;UWB-Tags zeigen</translation>
    </message>
    <message>
        <source>Show t&amp;rails</source>
        <translation>S&amp;puren zeigen</translation>
    </message>
    <message>
        <source>Show un&amp;certainty of UWB tags</source>
        <translation>Uns&amp;icherheit der UWB-Tags zeigen</translation>
    </message>
    <message>
        <source>Show UWB ra&amp;nges</source>
        <translation>UWB-Abstä&amp;nde zeigen</translation>
    </message>
    <message>
        <source>Circles of the ranges of the UWB tag that was clicked, or of the chosen AGV</source>
        <translation>Kreise der Abstände des angeklickten UWB-Tags oder des gewählten AGV</translation>
    </message>
    <message>
        <source>Show &amp;expected UWB accuracy</source>
        <translation>&amp;Erwartete UWB-Genauigkeit zeigen</translation>
    </message>
    <message>
        <source>How well the anchors can tell a place, from where they stand</source>
        <translation>Wie genau die Anker einen Ort bestimmen können, so wie sie stehen</translation>
    </message>
    <message>
        <source>Show &amp;overview when zoomed in</source>
        <translation>Ü&amp;bersicht zeigen, wenn vergrößert</translation>
    </message>
    <message>
        <source>10 seconds</source>
        <translation>10 Sekunden</translation>
    </message>
    <message>
        <source>1 minute</source>
        <translation>1 Minute</translation>
    </message>
    <message>
        <source>10 minutes</source>
        <translation>10 Minuten</translation>
    </message>
    <message>
        <source>2 metres</source>
        <translation>2 Meter</translation>
    </message>
    <message>
        <source>10 metres</source>
        <translation>10 Meter</translation>
    </message>
    <message>
        <source>&amp;Measure</source>
        <translation>&amp;Messen</translation>
    </message>
    <message>
        <source>Measure a distance on the map: click or drag from point to point</source>
        <translation>Einen Abstand auf der Karte messen: von Punkt zu Punkt klicken oder ziehen</translation>
    </message>
    <message>
        <source>Mo&amp;ve anchors</source>
        <translation>&amp;Anker verschieben</translation>
    </message>
    <message>
        <source>Drag UWB anchors to their places, in steps of 10 mm; with Shift 1 mm</source>
        <translation>UWB-Anker an ihren Ort ziehen, in Schritten von 10 mm; mit Umschalt 1 mm</translation>
    </message>
    <message>
        <source>&amp;Copy picture</source>
        <translation>Bild &amp;kopieren</translation>
    </message>
    <message>
        <source>Copy the map as it is shown</source>
        <translation>Die Karte kopieren, wie sie zu sehen ist</translation>
    </message>
    <message>
        <source>&amp;Save picture…</source>
        <translation>Bild &amp;speichern …</translation>
    </message>
    <message>
        <source>Save the map as it is shown, as PNG, SVG or PDF</source>
        <translation>Die Karte speichern, wie sie zu sehen ist, als PNG, SVG oder PDF</translation>
    </message>
    <message>
        <source>Alarms</source>
        <translation>Alarme</translation>
    </message>
    <message>
        <source>A&amp;larms</source>
        <translation>A&amp;larme</translation>
    </message>
    <message>
        <source>Show the list of alarms</source>
        <translation>Die Liste der Alarme zeigen</translation>
    </message>
    <message>
        <source>Acknowledge new ala&amp;rms</source>
        <translation>Neue Alarme &amp;quittieren</translation>
    </message>
    <message>
        <source>You know of the alarms chosen in the list; with none chosen, of all that are new</source>
        <translation>Sie kennen die in der Liste gewählten Alarme; ist keiner gewählt, alle neuen</translation>
    </message>
    <message>
        <source>Start of shift</source>
        <translation>Schichtbeginn</translation>
    </message>
    <message>
        <source>&amp;Start of shift: check everything</source>
        <translation>&amp;Schichtbeginn: alles prüfen</translation>
    </message>
    <message>
        <source>Look at plant file, links, batteries, floor tags, anchors, sleeptimes and disk; moves nothing</source>
        <translation>Anlagendatei, Verbindungen, Batterien, Bodentags, Anker, Sleeptimes und Platte ansehen; bewegt nichts</translation>
    </message>
    <message>
        <source>Drive by hand</source>
        <translation>Handfahrt</translation>
    </message>
    <message>
        <source>Plots</source>
        <translation>Kurven</translation>
    </message>
    <message>
        <source>&amp;Drive by hand</source>
        <translation>&amp;Handfahrt</translation>
    </message>
    <message>
        <source>Show the drive pad and give it the keyboard</source>
        <translation>Das Fahrfeld zeigen und ihm die Tastatur geben</translation>
    </message>
    <message>
        <source>Floor tags</source>
        <translation>Bodentags</translation>
    </message>
</context>
<context>
    <name>PlotPanel</name>
    <message>
        <source>S&amp;how</source>
        <translation>&amp;Zeigen</translation>
    </message>
    <message>
        <source>What the curves are</source>
        <translation>Was die Kurven sind</translation>
    </message>
    <message>
        <source>Whose curves</source>
        <translation>Wessen Kurven</translation>
    </message>
    <message>
        <source>How much time the plot shows</source>
        <translation>Wie viel Zeit zu sehen ist</translation>
    </message>
    <message>
        <source>&amp;Pause</source>
        <translation>&amp;Pause</translation>
    </message>
    <message>
        <source>Hold the picture; the data go on</source>
        <translation>Das Bild anhalten; die Daten laufen weiter</translation>
    </message>
    <message>
        <source>&amp;Follow</source>
        <translation>&amp;Folgen</translation>
    </message>
    <message>
        <source>Keep the newest values in sight</source>
        <translation>Die neuesten Werte im Blick behalten</translation>
    </message>
    <message>
        <source>E&amp;xport…</source>
        <translation>E&amp;xport …</translation>
    </message>
    <message>
        <source>Save the picture as PNG, SVG or PDF, or the visible values as CSV</source>
        <translation>Das Bild als PNG, SVG oder PDF speichern oder die sichtbaren Werte als CSV</translation>
    </message>
    <message>
        <source>Truly at</source>
        <translation>Wirklich bei</translation>
    </message>
    <message>
        <source>True x</source>
        <translation>Wahres x</translation>
    </message>
    <message>
        <source>True y</source>
        <translation>Wahres y</translation>
    </message>
    <message>
        <source>True heading</source>
        <translation>Wahre Richtung</translation>
    </message>
    <message>
        <source>&amp;Use</source>
        <translation>&amp;Verwenden</translation>
    </message>
    <message>
        <source>Take this pose as the true one of the chosen AGV; its errors are counted from now on</source>
        <translation>Diese Pose als die wahre des gewählten AGV nehmen; seine Fehler zählen von jetzt an</translation>
    </message>
    <message>
        <source>&amp;Take its pose</source>
        <translation>Seine Pose &amp;nehmen</translation>
    </message>
    <message>
        <source>Fill in the pose of now, to see how it drifts</source>
        <translation>Die jetzige Pose eintragen, um zu sehen, wie sie wandert</translation>
    </message>
    <message>
        <source>Over time</source>
        <translation>Über der Zeit</translation>
    </message>
    <message>
        <source>Distribution</source>
        <translation>Verteilung</translation>
    </message>
    <message>
        <source>Statistics of the visible values</source>
        <translation>Statistik der sichtbaren Werte</translation>
    </message>
</context>
<context>
    <name>ResultCard</name>
    <message>
        <source>Appl&amp;y suggested sleeptime</source>
        <translation>Vorgeschlagene Sleeptime über&amp;nehmen</translation>
    </message>
    <message>
        <source>Use this sleeptime for the next turns of this AGV, and keep it in the plant file if there is one</source>
        <translation>Diese Sleeptime für die nächsten Drehungen dieses AGV verwenden und in der Anlagendatei behalten, wenn es eine gibt</translation>
    </message>
    <message>
        <source>Use the sleeptime from before again, in the plant file too</source>
        <translation>Wieder die Sleeptime von vorher verwenden, auch in der Anlagendatei</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
</context>
<context>
    <name>ShiftPanel</name>
    <message>
        <source>Check &amp;everything</source>
        <translation>&amp;Alles prüfen</translation>
    </message>
    <message>
        <source>Look at plant file, links, batteries, floor tags, anchors, sleeptimes and disk; takes a few seconds and moves nothing</source>
        <translation>Anlagendatei, Verbindungen, Batterien, Bodentags, Anker, Sleeptimes und Platte ansehen; dauert ein paar Sekunden und bewegt nichts</translation>
    </message>
    <message>
        <source>Show a&amp;ll</source>
        <translation>A&amp;lle zeigen</translation>
    </message>
    <message>
        <source>List the checks that passed, too</source>
        <translation>Auch die bestandenen Prüfungen auflisten</translation>
    </message>
    <message>
        <source>Results of the checks</source>
        <translation>Ergebnisse der Prüfungen</translation>
    </message>
    <message>
        <source>Calibrate one after the &amp;other</source>
        <translation>&amp;Nacheinander kalibrieren</translation>
    </message>
    <message>
        <source>Every AGV that can turns once on the spot, one after the other: keep 500 mm around each of them clear</source>
        <translation>Jedes AGV, das kann, dreht sich einmal auf der Stelle, eins nach dem anderen: Halten Sie um jedes 500 mm frei</translation>
    </message>
    <message>
        <source>Sto&amp;p</source>
        <translation>A&amp;nhalten</translation>
    </message>
    <message>
        <source>Stop the turn that runs and start no other one</source>
        <translation>Die laufende Drehung abbrechen und keine weitere beginnen</translation>
    </message>
    <message>
        <source>Calibrations</source>
        <translation>Kalibrierungen</translation>
    </message>
    <message>
        <source>Verdict</source>
        <translation>Urteil</translation>
    </message>
</context>
<context>
    <name>agv::gui::AccuracyTexts</name>
    <message>
        <source>Expected UWB
accuracy, 95 %</source>
        <translation>Erwartete UWB-
Genauigkeit, 95 %</translation>
    </message>
    <message>
        <source>up to %1</source>
        <translation>bis %1</translation>
    </message>
    <message>
        <source>over %1</source>
        <translation>über %1</translation>
    </message>
    <message>
        <source>no position</source>
        <translation>keine Position</translation>
    </message>
</context>
<context>
    <name>agv::gui::AlarmLog</name>
    <message>
        <source>Alarm: %1. %2</source>
        <translation>Alarm: %1. %2</translation>
    </message>
    <message>
        <source>Alarm acknowledged: %1</source>
        <translation>Alarm quittiert: %1</translation>
    </message>
    <message>
        <source>Alarm over, not acknowledged: %1</source>
        <translation>Alarm vorbei, nicht quittiert: %1</translation>
    </message>
    <message>
        <source>Alarm shelved: %1</source>
        <translation>Alarm zurückgestellt: %1</translation>
    </message>
    <message>
        <source>Alarm over: %1</source>
        <translation>Alarm vorbei: %1</translation>
    </message>
</context>
<context>
    <name>agv::gui::AlarmPanel</name>
    <message>
        <source>No alarms: nothing asks for you.</source>
        <translation>Keine Alarme: Nichts braucht Sie.</translation>
    </message>
    <message>
        <source>For 10 minutes</source>
        <translation>Für 10 Minuten</translation>
    </message>
    <message>
        <source>For 1 hour</source>
        <translation>Für 1 Stunde</translation>
    </message>
    <message>
        <source>For the shift, 8 hours</source>
        <translation>Für die Schicht, 8 Stunden</translation>
    </message>
</context>
<context>
    <name>agv::gui::AlarmScreen</name>
    <message>
        <source>No alarms</source>
        <translation>Keine Alarme</translation>
    </message>
    <message>
        <source>Show the list of alarms</source>
        <translation>Die Liste der Alarme zeigen</translation>
    </message>
    <message>
        <source>Alarms: %1</source>
        <translation>Alarme: %1</translation>
    </message>
    <message>
        <source>Alarms: %1, %2 new</source>
        <translation>Alarme: %1, davon %2 neu</translation>
    </message>
</context>
<context>
    <name>agv::gui::AnchorSurveyDialog</name>
    <message>
        <source>&amp;Flip east and west</source>
        <translation>Ost und West &amp;tauschen</translation>
    </message>
    <message>
        <source>&amp;Measure again</source>
        <translation>&amp;Erneut messen</translation>
    </message>
    <message>
        <source>&amp;Move the anchors</source>
        <translation>Anker &amp;versetzen</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Ver&amp;werfen</translation>
    </message>
    <message>
        <source>Place anchors</source>
        <translation>Anker einmessen</translation>
    </message>
    <message>
        <source>Places found from the ranges between the anchors. Hollow: where the list has an anchor now. Filled: where it would go, and how far. Heights stay as they are.</source>
        <translation>Orte aus den Abständen der Anker untereinander. Hohl: wo ein Anker in der Liste jetzt steht. Gefüllt: wohin er käme, und wie weit. Die Höhen bleiben.</translation>
    </message>
    <message>
        <source>&amp;Lay it</source>
        <translation>&amp;Lage</translation>
    </message>
    <message>
        <source>&amp;Turn by</source>
        <translation>&amp;Drehen um</translation>
    </message>
    <message>
        <source>Closest to the present list, or with one anchor as the origin of the plant</source>
        <translation>Möglichst nahe an der jetzigen Liste, oder mit einem Anker als Ursprung der Anlage</translation>
    </message>
    <message>
        <source>Ranges alone do not tell a plan from its mirror image</source>
        <translation>Abstände allein unterscheiden einen Plan nicht von seinem Spiegelbild</translation>
    </message>
    <message>
        <source>Counter-clockwise</source>
        <translation>Gegen den Uhrzeigersinn</translation>
    </message>
    <message>
        <source>Compute the places from the newest ranges between the anchors</source>
        <translation>Die Orte aus den neuesten Abständen der Anker untereinander berechnen</translation>
    </message>
    <message>
        <source>Put the proposed places into the list; one Undo takes them back</source>
        <translation>Die vorgeschlagenen Orte in die Liste übernehmen; einmal Rückgängig nimmt sie zurück</translation>
    </message>
    <message>
        <source>Close; the anchors stay where they are</source>
        <translation>Schließen; die Anker bleiben, wo sie sind</translation>
    </message>
    <message>
        <source>closest to the present list</source>
        <translation>möglichst nahe an der jetzigen Liste</translation>
    </message>
    <message>
        <source>with %1 at the origin</source>
        <translation>mit %1 im Ursprung</translation>
    </message>
    <message>
        <source>Computing the places…</source>
        <translation>Die Orte werden berechnet…</translation>
    </message>
    <message>
        <source>The anchors do not range each other.</source>
        <translation>Die Anker messen einander nicht.</translation>
    </message>
    <message>
        <source>Ranges minus distances: %1 (root mean square). Least certain place: ±%2.</source>
        <translation>Gemessen minus Abstand: %1 (quadratisches Mittel). Unsicherster Ort: ±%2.</translation>
    </message>
</context>
<context>
    <name>agv::gui::AnchorSurveyView</name>
    <message>
        <source>Present and proposed places of the anchors</source>
        <translation>Jetzige und vorgeschlagene Orte der Anker</translation>
    </message>
    <message>
        <source>stays</source>
        <translation>bleibt</translation>
    </message>
</context>
<context>
    <name>agv::gui::CalibrationPanel</name>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>The robot of %1 is not connected. Switch it on; it connects by itself.</source>
        <translation>Der Roboter von %1 ist nicht verbunden. Schalten Sie ihn ein; er verbindet sich selbst.</translation>
    </message>
    <message>
        <source>The RFID reader of %1 is closed. Press Open RFID.</source>
        <translation>Der RFID-Leser von %1 ist geschlossen. Drücken Sie „RFID öffnen“.</translation>
    </message>
    <message>
        <source>Stop %1 of %2, %3. %4 left.</source>
        <translation>Stopp %1 von %2, %3. Noch %4.</translation>
    </message>
    <message>
        <source>Ready. %1 turns once on the spot: keep %2 around it clear.</source>
        <translation>Bereit. %1 dreht sich einmal auf der Stelle: Halten Sie %2 ringsum frei.</translation>
    </message>
    <message>
        <source>No turn yet. Press Calibrate: each stop adds a row with the tags read and their RSSI.</source>
        <translation>Noch keine Drehung. Drücken Sie „Kalibrieren“: Jeder Stopp fügt eine Zeile mit den gelesenen Tags und ihrem RSSI hinzu.</translation>
    </message>
    <message>
        <source>The plant file names no AGV.</source>
        <translation>Die Anlagendatei nennt kein AGV.</translation>
    </message>
    <message>
        <source>The robot of %1 cannot connect: %2.</source>
        <translation>Der Roboter von %1 kann sich nicht verbinden: %2.</translation>
    </message>
    <message>
        <source>The RFID reader of %1 does not deliver: %2.</source>
        <translation>Der RFID-Leser von %1 liefert nichts: %2.</translation>
    </message>
</context>
<context>
    <name>agv::gui::CorrectionDialog</name>
    <message>
        <source>Correction table</source>
        <translation>Korrekturtabelle</translation>
    </message>
    <message>
        <source>Added to each measured range, in cm. A range that reads too long needs a negative correction. An empty cell adds nothing.</source>
        <translation>Wird zu jedem gemessenen Abstand addiert, in cm. Ein zu lang gemessener Abstand braucht eine negative Korrektur. Ein leeres Feld addiert nichts.</translation>
    </message>
    <message>
        <source>Range corrections</source>
        <translation>Abstandskorrekturen</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>Rückgängig</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>Wiederholen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
    <message>
        <source>No corrections: there are no anchors. Add them in the panel UWB anchors.</source>
        <translation>Keine Korrekturen: Es gibt keine Anker. Fügen Sie sie im Feld UWB-Anker hinzu.</translation>
    </message>
    <message>
        <source>No corrections: no tag is listed or heard. Add one in the panel UWB tags, or switch one on.</source>
        <translation>Keine Korrekturen: Kein Tag ist eingetragen oder zu hören. Fügen Sie im Feld UWB-Tags eines hinzu oder schalten Sie eines ein.</translation>
    </message>
</context>
<context>
    <name>agv::gui::EventPanel</name>
    <message>
        <source>Nothing has happened yet. Connections, turns and errors are written here.</source>
        <translation>Noch ist nichts geschehen. Verbindungen, Drehungen und Fehler erscheinen hier.</translation>
    </message>
</context>
<context>
    <name>agv::gui::FloorTagPanel</name>
    <message>
        <source>All</source>
        <translation>Alle</translation>
    </message>
    <message>
        <source>The plant file names no floor tags. Add a grid or a list of surveyed tags to it.</source>
        <translation>Die Anlagendatei nennt keine Bodentags. Tragen Sie ein Raster oder eine Liste vermessener Tags ein.</translation>
    </message>
    <message>
        <source>No floor tag fits the filter.</source>
        <translation>Kein Bodentag passt zum Filter.</translation>
    </message>
</context>
<context>
    <name>agv::gui::JogPad</name>
    <message>
        <source>Curve ahead to the left</source>
        <translation>Kurve vorwärts nach links</translation>
    </message>
    <message>
        <source>Ahead</source>
        <translation>Vorwärts</translation>
    </message>
    <message>
        <source>Curve ahead to the right</source>
        <translation>Kurve vorwärts nach rechts</translation>
    </message>
    <message>
        <source>Turn left on the spot</source>
        <translation>Auf der Stelle nach links drehen</translation>
    </message>
    <message>
        <source>Turn right on the spot</source>
        <translation>Auf der Stelle nach rechts drehen</translation>
    </message>
    <message>
        <source>Curve back to the left</source>
        <translation>Kurve rückwärts nach links</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>Rückwärts</translation>
    </message>
    <message>
        <source>Curve back to the right</source>
        <translation>Kurve rückwärts nach rechts</translation>
    </message>
    <message>
        <source>Drive pad</source>
        <translation>Fahrfeld</translation>
    </message>
    <message>
        <source>Hold W, A, S, D or an arrow key to drive while this pad has the keyboard; space stops this AGV</source>
        <translation>W, A, S, D oder eine Pfeiltaste halten, um zu fahren, solange dieses Feld die Tastatur hat; die Leertaste hält dieses AGV an</translation>
    </message>
    <message>
        <source>%1: drives as long as you hold it</source>
        <translation>%1: fährt, solange Sie halten</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Anhalten</translation>
    </message>
    <message>
        <source>Stop this AGV, whatever it does (space). Software stop, does not replace the emergency stop.</source>
        <translation>Dieses AGV anhalten, was immer es tut (Leertaste). Software-Halt, ersetzt nicht den Not-Halt.</translation>
    </message>
</context>
<context>
    <name>agv::gui::JogPanel</name>
    <message>
        <source>It is driven already: mouse and keys do not drive together.</source>
        <translation>Es wird schon gefahren: Maus und Tasten fahren nicht zusammen.</translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>This window did not react for a moment, so the press was not sent. Press again.</source>
        <translation>Dieses Fenster hat einen Moment nicht reagiert, darum wurde nichts gesendet. Drücken Sie noch einmal.</translation>
    </message>
    <message>
        <source>%1 drives: left wheel %2, right wheel %3.</source>
        <translation>%1 fährt: linkes Rad %2, rechtes Rad %3.</translation>
    </message>
    <message>
        <source>%1. Let go, then press again.</source>
        <translation>%1. Loslassen, dann neu drücken.</translation>
    </message>
    <message>
        <source>%1 cannot be driven now: %2.</source>
        <translation>%1 lässt sich jetzt nicht fahren: %2.</translation>
    </message>
    <message>
        <source>Ready. %1 drives as long as you hold an arrow.</source>
        <translation>Bereit. %1 fährt, solange Sie einen Pfeil halten.</translation>
    </message>
</context>
<context>
    <name>agv::gui::LinksPanel</name>
    <message>
        <source>No AGVs. The plant file names none; add them there and start again.</source>
        <translation>Keine AGVs. Die Anlagendatei nennt keine; tragen Sie sie dort ein und starten Sie neu.</translation>
    </message>
    <message>
        <source>Refused, not in the plant file: %1</source>
        <translation>Abgewiesen, nicht in der Anlagendatei: %1</translation>
    </message>
    <message>
        <source>AGV %1 reads no floor tag</source>
        <translation>AGV %1 liest kein Bodentag</translation>
    </message>
    <message>
        <source>AGV %1 reads tag (RSSI): %2</source>
        <translation>AGV %1 liest Tag (RSSI): %2</translation>
    </message>
    <message>
        <source>&amp;Open UWB</source>
        <translation>UWB ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Open RFID</source>
        <translation>RFID ö&amp;ffnen</translation>
    </message>
    <message>
        <source>&amp;Close UWB</source>
        <translation>UWB schli&amp;eßen</translation>
    </message>
    <message>
        <source>&amp;Close RFID</source>
        <translation>RFID schli&amp;eßen</translation>
    </message>
    <message>
        <source>Open the serial port of the UWB unit</source>
        <translation>Die serielle Schnittstelle der UWB-Einheit öffnen</translation>
    </message>
    <message>
        <source>Open the RFID reader of the chosen row; with none chosen, all readers</source>
        <translation>Den RFID-Leser der gewählten Zeile öffnen; ist keine gewählt, alle Leser</translation>
    </message>
    <message>
        <source>Close the serial port of the UWB unit</source>
        <translation>Die serielle Schnittstelle der UWB-Einheit schließen</translation>
    </message>
    <message>
        <source>Close the RFID reader of the chosen row; with none chosen, all readers</source>
        <translation>Den RFID-Leser der gewählten Zeile schließen; ist keine gewählt, alle Leser</translation>
    </message>
</context>
<context>
    <name>agv::gui::MainWindow</name>
    <message>
        <source>Links: %1 of %2 up, %3 disturbed</source>
        <translation>Verbindungen: %1 von %2, %3 gestört</translation>
    </message>
    <message>
        <source>Links: %1 of %2 up</source>
        <translation>Verbindungen: %1 von %2 stehen</translation>
    </message>
    <message>
        <source>x %1   y %2</source>
        <translation>x %1   y %2</translation>
    </message>
    <message>
        <source>Plant: %1</source>
        <translation>Anlage: %1</translation>
    </message>
    <message>
        <source>Stop all</source>
        <translation>Alle anhalten</translation>
    </message>
    <message>
        <source>Stop all AGVs now (Esc). Software stop, does not replace the emergency stop.</source>
        <translation>Alle AGVs jetzt anhalten (Esc). Software-Halt, ersetzt nicht den Not-Halt.</translation>
    </message>
    <message>
        <source>About AGV Console</source>
        <translation>Über den AGV-Leitstand</translation>
    </message>
    <message>
        <source>&lt;b&gt;AGV Console&lt;/b&gt;&lt;p&gt;Locate, calibrate and watch the AGVs of a pipeless plant.&lt;/p&gt;&lt;p&gt;Free software under the GNU General Public License, version 3 or later. Made with Qt, QCustomPlot and Eigen.&lt;/p&gt;</source>
        <translation>&lt;b&gt;AGV-Leitstand&lt;/b&gt;&lt;p&gt;Die AGVs einer rohrlosen Anlage orten, kalibrieren und beobachten.&lt;/p&gt;&lt;p&gt;Freie Software unter der GNU General Public License, Version 3 oder neuer. Erstellt mit Qt, QCustomPlot und Eigen.&lt;/p&gt;</translation>
    </message>
    <message>
        <source>Calibrate %1</source>
        <translation>%1 kalibrieren</translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;The simulation has ended.&lt;/b&gt; %1. Start the console again.</source>
        <translation>&lt;b&gt;Die Simulation ist zu Ende.&lt;/b&gt; %1. Starten Sie die Konsole neu.</translation>
    </message>
    <message>
        <source>Robots cannot connect</source>
        <translation>Roboter können sich nicht verbinden</translation>
    </message>
    <message>
        <source>Robots connect to: %1</source>
        <translation>Roboter verbinden sich mit: %1</translation>
    </message>
    <message>
        <source>&lt;b&gt;No robot can connect.&lt;/b&gt; %1. It is tried again by itself.</source>
        <translation>&lt;b&gt;Kein Roboter kann sich verbinden.&lt;/b&gt; %1. Es wird von selbst wieder versucht.</translation>
    </message>
    <message>
        <source>AGV Console[*]</source>
        <translation>AGV-Leitstand[*]</translation>
    </message>
    <message>
        <source>%1[*] – AGV Console</source>
        <translation>%1[*] – AGV-Leitstand</translation>
    </message>
</context>
<context>
    <name>agv::gui::MapControls</name>
    <message>
        <source>x %1, y %2</source>
        <translation>x %1, y %2</translation>
    </message>
    <message>
        <source>Copy %1</source>
        <translation>%1 kopieren</translation>
    </message>
    <message>
        <source>Measure from here</source>
        <translation>Von hier aus messen</translation>
    </message>
    <message>
        <source>Centre here</source>
        <translation>Hierher zentrieren</translation>
    </message>
    <message>
        <source>Save the map as a picture</source>
        <translation>Karte als Bild speichern</translation>
    </message>
    <message>
        <source>The map was saved as %1</source>
        <translation>Die Karte wurde als %1 gespeichert</translation>
    </message>
</context>
<context>
    <name>agv::gui::MapWidget</name>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>x %1, y %2, facing %3</source>
        <translation>x %1, y %2, Blickrichtung %3</translation>
    </message>
    <message>
        <source>Battery %1</source>
        <translation>Batterie %1</translation>
    </message>
    <message>
        <source>May be moving: the connection was lost while the wheels were turning.</source>
        <translation>Fährt vielleicht noch: Die Verbindung brach ab, während sich die Räder drehten.</translation>
    </message>
    <message>
        <source>AGV %1, stop %2: antenna at x %3, y %4
Tags expected %5, seen %6, missed %7, unknown %8</source>
        <translation>AGV %1, Stopp %2: Antenne bei x %3, y %4
Tags erwartet %5, gesehen %6, vermisst %7, unbekannt %8</translation>
    </message>
    <message>
        <source>Floor tag %1 (%2)
%3
x %4, y %5</source>
        <translation>Bodentag %1 (%2)
%3
x %4, y %5</translation>
    </message>
    <message>
        <source>Station %1
x %2, y %3</source>
        <translation>Station %1
x %2, y %3</translation>
    </message>
    <message>
        <source>Map of the plant</source>
        <translation>Karte der Anlage</translation>
    </message>
    <message>
        <source>UWB tag %1</source>
        <translation>UWB-Tag %1</translation>
    </message>
    <message>
        <source>UWB tag %1, %2</source>
        <translation>UWB-Tag %1, %2</translation>
    </message>
    <message>
        <source>On AGV %1</source>
        <translation>Auf AGV %1</translation>
    </message>
    <message>
        <source>x %1, y %2, 95 % within %3 by %4</source>
        <translation>x %1, y %2, zu 95 % innerhalb %3 mal %4</translation>
    </message>
    <message>
        <source>%1 ranges, %2 of them obstructed</source>
        <translation>%1 Abstände, davon %2 verdeckt</translation>
    </message>
    <message>
        <source>%1, %2 exchanges missed</source>
        <translation>%1, %2 Messungen verpasst</translation>
    </message>
    <message>
        <source>UWB anchor %1, %2
x %3, y %4, height %5</source>
        <translation>UWB-Anker %1, %2
x %3, y %4, Höhe %5</translation>
    </message>
    <message>
        <source>Seen in this session</source>
        <translation>In dieser Sitzung gelesen</translation>
    </message>
    <message>
        <source>Missing: a turn should have read it and did not</source>
        <translation>Fehlt: Eine Drehung hätte ihn lesen müssen und hat es nicht</translation>
    </message>
    <message>
        <source>Unknown floor tag %1 was read here; the plant file does not name it</source>
        <translation>Unbekannter Bodentag %1 wurde hier gelesen; die Anlagendatei nennt ihn nicht</translation>
    </message>
    <message>
        <source>UWB positions here: 95 % within about %1, as the anchors stand</source>
        <translation>UWB-Positionen hier: 95 % innerhalb von etwa %1, so wie die Anker stehen</translation>
    </message>
    <message>
        <source>No UWB position here: the anchors stand too much in one direction</source>
        <translation>Keine UWB-Position hier: Die Anker stehen zu sehr in einer Richtung</translation>
    </message>
</context>
<context>
    <name>agv::gui::MeasureTexts</name>
    <message>
        <source>%1 along x, %2 along y</source>
        <translation>%1 entlang x, %2 entlang y</translation>
    </message>
</context>
<context>
    <name>agv::gui::NextStep</name>
    <message>
        <source>The plant file holds no floor tags, so no AGV can be located.</source>
        <translation>Die Anlagendatei enthält keine Bodentags; kein AGV kann geortet werden.</translation>
    </message>
    <message>
        <source>The plant file names no AGV. Add one there and start again.</source>
        <translation>Die Anlagendatei nennt kein AGV. Tragen Sie dort eines ein und starten Sie neu.</translation>
    </message>
    <message>
        <source>Turning: AGV %1. Esc stops all AGVs.</source>
        <translation>Es dreht sich: AGV %1. Esc hält alle AGVs an.</translation>
    </message>
    <message>
        <source>First press Open RFID, so that the AGVs can read the floor tags.</source>
        <translation>Drücken Sie zuerst „RFID öffnen“, damit die AGVs die Bodentags lesen können.</translation>
    </message>
    <message>
        <source>Switch the AGVs on. They connect by themselves; none has yet.</source>
        <translation>Schalten Sie die AGVs ein. Sie verbinden sich von selbst; bisher keines.</translation>
    </message>
    <message>
        <source>Not located yet: AGV %1. Choose one and press Calibrate.</source>
        <translation>Noch nicht geortet: AGV %1. Wählen Sie eines und drücken Sie „Kalibrieren“.</translation>
    </message>
    <message>
        <source>AGV %1 may still be moving: go and look, and use the switch of the AGV.</source>
        <translation>AGV %1 fährt vielleicht noch: Sehen Sie nach und benutzen Sie den Schalter des AGV.</translation>
    </message>
    <message>
        <source>No longer where it was located: AGV %1. Choose it and press Calibrate.</source>
        <translation>Nicht mehr dort, wo es geortet wurde: AGV %1. Wählen Sie es und drücken Sie Kalibrieren.</translation>
    </message>
</context>
<context>
    <name>agv::gui::PictureTexts</name>
    <message>
        <source>Picture (*.png)</source>
        <translation>Bild (*.png)</translation>
    </message>
    <message>
        <source>Drawing (*.svg)</source>
        <translation>Zeichnung (*.svg)</translation>
    </message>
    <message>
        <source>Document (*.pdf)</source>
        <translation>Dokument (*.pdf)</translation>
    </message>
</context>
<context>
    <name>agv::gui::PlantFileDialog</name>
    <message>
        <source>&amp;Choose another file…</source>
        <translation>&amp;Andere Datei wählen …</translation>
    </message>
    <message>
        <source>&amp;Use the built-in plant</source>
        <translation>&amp;Eingebaute Anlage verwenden</translation>
    </message>
    <message>
        <source>Plant file</source>
        <translation>Anlagendatei</translation>
    </message>
    <message>
        <source>The plant file cannot be used.</source>
        <translation>Die Anlagendatei kann nicht verwendet werden.</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>&amp;Beenden</translation>
    </message>
    <message>
        <source>Open plant file</source>
        <translation>Anlagendatei öffnen</translation>
    </message>
    <message>
        <source>Plant files (*.json);;All files (*)</source>
        <translation>Anlagendateien (*.json);;Alle Dateien (*)</translation>
    </message>
</context>
<context>
    <name>agv::gui::PlotPanel</name>
    <message>
        <source>30 seconds</source>
        <translation>30 Sekunden</translation>
    </message>
    <message>
        <source>2 minutes</source>
        <translation>2 Minuten</translation>
    </message>
    <message>
        <source>10 minutes</source>
        <translation>10 Minuten</translation>
    </message>
    <message>
        <source>1 hour</source>
        <translation>1 Stunde</translation>
    </message>
    <message>
        <source>Everything</source>
        <translation>Alles</translation>
    </message>
    <message>
        <source>All tags</source>
        <translation>Alle Tags</translation>
    </message>
    <message>
        <source>All AGVs</source>
        <translation>Alle AGVs</translation>
    </message>
    <message>
        <source>Tag %1</source>
        <translation>Tag %1</translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>Time since the start, s</source>
        <translation>Zeit seit dem Start, s</translation>
    </message>
    <message>
        <source>Share that is not larger, %</source>
        <translation>Anteil, der nicht größer ist, %</translation>
    </message>
    <message>
        <source>Type where the AGV truly is, choose the AGV above, and press Use.</source>
        <translation>Geben Sie ein, wo das AGV wirklich steht, wählen Sie oben das AGV und drücken Sie „Verwenden“.</translation>
    </message>
    <message>
        <source>No position yet: calibrate an AGV.</source>
        <translation>Noch keine Position: Kalibrieren Sie ein AGV.</translation>
    </message>
    <message>
        <source>No UWB ranges yet: open the UWB unit and switch a tag on.</source>
        <translation>Noch keine UWB-Abstände: Öffnen Sie die UWB-Einheit und schalten Sie einen Tag ein.</translation>
    </message>
    <message>
        <source>Nothing yet: connect an AGV.</source>
        <translation>Noch nichts: Verbinden Sie ein AGV.</translation>
    </message>
    <message>
        <source>Statistics of the visible part of the curves.</source>
        <translation>Statistik des sichtbaren Teils der Kurven.</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Export the plot</source>
        <translation>Kurven exportieren</translation>
    </message>
    <message>
        <source>Visible values (*.csv)</source>
        <translation>Sichtbare Werte (*.csv)</translation>
    </message>
    <message>
        <source>The plot was saved as %1</source>
        <translation>Die Kurven wurden als %1 gespeichert</translation>
    </message>
</context>
<context>
    <name>agv::gui::RangeCalibrationDialog</name>
    <message>
        <source>%1 of the known point in mm</source>
        <translation>%1 des bekannten Punkts in mm</translation>
    </message>
    <message>
        <source>Calibrate ranges</source>
        <translation>Abstände kalibrieren</translation>
    </message>
    <message>
        <source>Put the tag at a point whose place you know, with a free view of every anchor. Keep it still and step aside while ranges are collected.</source>
        <translation>Stellen Sie das Tag an einen Punkt, dessen Ort Sie kennen, mit freier Sicht auf jeden Anker. Lassen Sie es ruhig stehen und treten Sie zur Seite, während Abstände gesammelt werden.</translation>
    </message>
    <message>
        <source>Height of the tag&apos;s antenna above the floor</source>
        <translation>Höhe der Antenne des Tags über dem Boden</translation>
    </message>
    <message>
        <source> s</source>
        <translation> s</translation>
    </message>
    <message>
        <source>Place of an &amp;AGV</source>
        <translation>Ort eines &amp;AGV</translation>
    </message>
    <message>
        <source>Take over where an AGV stands now; with the tag&apos;s place on it, when it carries the tag</source>
        <translation>Übernehmen, wo ein AGV jetzt steht; trägt es das Tag, mit dem Platz des Tags darauf</translation>
    </message>
    <message>
        <source>number or ID</source>
        <translation>Nummer oder ID</translation>
    </message>
    <message>
        <source>Place of this &amp;floor tag</source>
        <translation>Ort dieses &amp;Bodentags</translation>
    </message>
    <message>
        <source>Take over where the floor tag with this number or ID lies</source>
        <translation>Übernehmen, wo das Bodentag mit dieser Nummer oder ID liegt</translation>
    </message>
    <message>
        <source>&amp;Tag</source>
        <translation>&amp;Tag</translation>
    </message>
    <message>
        <source>Known point (mm)</source>
        <translation>Bekannter Punkt (mm)</translation>
    </message>
    <message>
        <source>&amp;Duration</source>
        <translation>&amp;Dauer</translation>
    </message>
    <message>
        <source>Progress</source>
        <translation>Fortschritt</translation>
    </message>
    <message>
        <source>Corrections found</source>
        <translation>Gefundene Korrekturen</translation>
    </message>
    <message>
        <source>No ranges yet. Choose the tag, enter where it stands, and start.</source>
        <translation>Noch keine Abstände. Wählen Sie das Tag, tragen Sie ein, wo es steht, und starten Sie.</translation>
    </message>
    <message>
        <source>&amp;Use these corrections</source>
        <translation>Diese Korrekturen über&amp;nehmen</translation>
    </message>
    <message>
        <source>Put them into the correction table; one Undo takes them back</source>
        <translation>In die Korrekturtabelle übernehmen; einmal Rückgängig nimmt sie zurück</translation>
    </message>
    <message>
        <source>No AGV is located yet: calibrate one first</source>
        <translation>Noch kein AGV hat eine Position: erst eines kalibrieren</translation>
    </message>
    <message>
        <source>There is no floor tag &quot;%1&quot;.</source>
        <translation>Es gibt kein Bodentag „%1“.</translation>
    </message>
    <message>
        <source>%1 floor tags end in &quot;%2&quot;: enter more digits.</source>
        <translation>%1 Bodentags enden auf „%2“: mehr Stellen eingeben.</translation>
    </message>
    <message>
        <source>&amp;Cancel</source>
        <translation>A&amp;bbrechen</translation>
    </message>
    <message>
        <source>&amp;Start</source>
        <translation>&amp;Start</translation>
    </message>
    <message>
        <source>&amp;Start again</source>
        <translation>Erneut &amp;starten</translation>
    </message>
    <message>
        <source>Give up this collection</source>
        <translation>Diese Sammlung aufgeben</translation>
    </message>
    <message>
        <source>Collect ranges of the tag at the known point</source>
        <translation>Abstände des Tags am bekannten Punkt sammeln</translation>
    </message>
    <message>
        <source>&amp;Discard</source>
        <translation>Ver&amp;werfen</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close; the correction table stays as it is</source>
        <translation>Schließen; die Korrekturtabelle bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>There are no anchors. Add them in the panel UWB anchors.</source>
        <translation>Es gibt keine Anker. Fügen Sie sie im Feld UWB-Anker hinzu.</translation>
    </message>
    <message>
        <source>The UWB unit is not connected. Open it in the panel Links.</source>
        <translation>Die UWB-Einheit ist nicht verbunden. Öffnen Sie sie im Feld Verbindungen.</translation>
    </message>
    <message>
        <source>No tag is listed or heard. Switch the tag on, or add it in the panel UWB tags.</source>
        <translation>Kein Tag ist eingetragen oder zu hören. Schalten Sie das Tag ein oder fügen Sie es im Feld UWB-Tags hinzu.</translation>
    </message>
    <message>
        <source>No corrections: %1</source>
        <translation>Keine Korrekturen: %1</translation>
    </message>
    <message>
        <source>Finished. Look at the spread, then use or discard the corrections of %1.</source>
        <translation>Fertig. Prüfen Sie die Streuung, dann übernehmen oder verwerfen Sie die Korrekturen von %1.</translation>
    </message>
    <message>
        <source>Finished, but some ranges vary much: was the view blocked, or the tag moved?</source>
        <translation>Fertig, aber einige Abstände streuen stark: War die Sicht verdeckt, oder wurde das Tag bewegt?</translation>
    </message>
    <message>
        <source>Collecting ranges of %1: leave the tag where it is.</source>
        <translation>Abstände von %1 werden gesammelt: Lassen Sie das Tag stehen.</translation>
    </message>
    <message>
        <source>Enter where the antenna of the tag is, then start.</source>
        <translation>Tragen Sie ein, wo die Antenne des Tags ist, dann starten Sie.</translation>
    </message>
    <message>
        <source>Calibrate ranges of %1</source>
        <translation>Abstände von %1 kalibrieren</translation>
    </message>
</context>
<context>
    <name>agv::gui::RangeTexts</name>
    <message>
        <source>obstructed</source>
        <translation>verdeckt</translation>
    </message>
    <message>
        <source>clear</source>
        <translation>frei</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
</context>
<context>
    <name>agv::gui::ResultCard</name>
    <message>
        <source>Turn aborted</source>
        <translation>Drehung abgebrochen</translation>
    </message>
    <message>
        <source>Turn failed</source>
        <translation>Drehung fehlgeschlagen</translation>
    </message>
    <message>
        <source>The AGV may still be moving: the connection was lost while its wheels were turning. Go and look before you start again.</source>
        <translation>Das AGV fährt vielleicht noch: Die Verbindung brach ab, während sich seine Räder drehten. Sehen Sie nach, bevor Sie neu beginnen.</translation>
    </message>
    <message>
        <source>The wheels have been set to zero. Press Calibrate to start again.</source>
        <translation>Die Räder wurden auf null gesetzt. Drücken Sie „Kalibrieren“, um neu zu beginnen.</translation>
    </message>
    <message>
        <source>Undo: sleeptime %1 again</source>
        <translation>Rückgängig: wieder Sleeptime %1</translation>
    </message>
</context>
<context>
    <name>agv::gui::ResultText</name>
    <message>
        <source>Position found</source>
        <translation>Position gefunden</translation>
    </message>
    <message>
        <source>Two positions are possible</source>
        <translation>Zwei Positionen sind möglich</translation>
    </message>
    <message>
        <source>Position found, please check</source>
        <translation>Position gefunden, bitte prüfen</translation>
    </message>
    <message>
        <source>No position found</source>
        <translation>Keine Position gefunden</translation>
    </message>
    <message>
        <source>The reads of this turn do not tell where %1 stands.</source>
        <translation>Aus den Lesungen dieser Drehung geht nicht hervor, wo %1 steht.</translation>
    </message>
    <message>
        <source>%1 stands at x %2, y %3 and faces %4. With 95 % certainty within ±%5 and ±%6.</source>
        <translation>%1 steht bei x %2, y %3 und blickt nach %4. Mit 95 % Sicherheit innerhalb ±%5 und ±%6.</translation>
    </message>
    <message>
        <source>Solver status: %1.</source>
        <translation>Status des Lösers: %1.</translation>
    </message>
    <message>
        <source>The uncertainty is too large for driving. Repeat the turn with a longer dwell.</source>
        <translation>Die Unsicherheit ist zum Fahren zu groß. Wiederholen Sie die Drehung mit längerem Verweilen.</translation>
    </message>
    <message>
        <source>A second position explains the reads nearly as well: x %1, y %2, facing %3 (dashed on the map). Look which one is right, or repeat the turn with 12 or 16 stops.</source>
        <translation>Eine zweite Position erklärt die Lesungen fast ebenso gut: x %1, y %2, Blickrichtung %3 (auf der Karte gestrichelt). Sehen Sie nach, welche stimmt, oder wiederholen Sie die Drehung mit 12 oder 16 Stopps.</translation>
    </message>
    <message>
        <source>A second position explains the reads nearly as well. Repeat the turn with 12 or 16 stops.</source>
        <translation>Eine zweite Position erklärt die Lesungen fast ebenso gut. Wiederholen Sie die Drehung mit 12 oder 16 Stopps.</translation>
    </message>
    <message>
        <source>Too few tags were read. Is the AGV on the tag field, and the reader powered?</source>
        <translation>Es wurden zu wenige Tags gelesen. Steht das AGV auf dem Tagfeld, und hat der Leser Strom?</translation>
    </message>
    <message>
        <source>The AGV turned against the commanded direction. Check that its wheels are not swapped.</source>
        <translation>Das AGV drehte gegen die befohlene Richtung. Prüfen Sie, ob die Räder vertauscht sind.</translation>
    </message>
    <message>
        <source>The steps differ more than usual. Check the wheels for slip and the battery.</source>
        <translation>Die Schritte sind ungleicher als üblich. Prüfen Sie die Räder auf Schlupf und die Batterie.</translation>
    </message>
    <message>
        <source>The reads contradict the plant file. Check the floor tags and the RSSI table.</source>
        <translation>Die Lesungen widersprechen der Anlagendatei. Prüfen Sie Bodentags und RSSI-Tabelle.</translation>
    </message>
    <message>
        <source>No tag was read. Check the RFID reader&apos;s link and that the AGV stands on the tag field.</source>
        <translation>Es wurde kein Tag gelesen. Prüfen Sie die Verbindung des RFID-Lesers und ob das AGV auf dem Tagfeld steht.</translation>
    </message>
    <message>
        <source>The computation ran out of its budget. Repeat the turn.</source>
        <translation>Die Berechnung wurde nicht rechtzeitig fertig. Wiederholen Sie die Drehung.</translation>
    </message>
    <message>
        <source>The steps were %1 instead of %2: a sleeptime of %3 fits (±%4).</source>
        <translation>Die Schritte waren %1 statt %2: Eine Sleeptime von %3 passt (±%4).</translation>
    </message>
    <message>
        <source>x %1, y %2, facing %3 (95 %: ±%4, ±%5)</source>
        <translation>x %1, y %2, Blick nach %3 (95 %: ±%4, ±%5)</translation>
    </message>
    <message>
        <source>So far: %1; a second position is still possible</source>
        <translation>Bisher: %1; eine zweite Position ist noch möglich</translation>
    </message>
    <message>
        <source>So far: %1</source>
        <translation>Bisher: %1</translation>
    </message>
</context>
<context>
    <name>agv::gui::SerialPortDialog</name>
    <message>
        <source>trek (TREK1000, firmware 2.x)</source>
        <translation>trek (TREK1000, Firmware 2.x)</translation>
    </message>
    <message>
        <source>trek-1.06 (TREK1000, firmware 1.06)</source>
        <translation>trek-1.06 (TREK1000, Firmware 1.06)</translation>
    </message>
    <message>
        <source>ulm4 (ULM1, LD600)</source>
        <translation>ulm4 (ULM1, LD600)</translation>
    </message>
    <message>
        <source>ulm8 (ULM3)</source>
        <translation>ulm8 (ULM3)</translation>
    </message>
    <message>
        <source>esp32 (as trek, without a time)</source>
        <translation>esp32 (wie trek, ohne Zeit)</translation>
    </message>
    <message>
        <source>imu (metres, motion sensors)</source>
        <translation>imu (Meter, Bewegungssensoren)</translation>
    </message>
    <message>
        <source>found from what the unit writes</source>
        <translation>aus dem gefunden, was die Einheit schreibt</translation>
    </message>
    <message>
        <source>&amp;Ask the unit</source>
        <translation>Einheit &amp;fragen</translation>
    </message>
    <message>
        <source>&amp;Use this port</source>
        <translation>Diesen Port &amp;verwenden</translation>
    </message>
    <message>
        <source>Port of the UWB unit</source>
        <translation>Port der UWB-Einheit</translation>
    </message>
    <message>
        <source>&amp;List again</source>
        <translation>Neu auf&amp;listen</translation>
    </message>
    <message>
        <source>Look again which serial ports this computer has</source>
        <translation>Erneut nachsehen, welche seriellen Ports dieser Rechner hat</translation>
    </message>
    <message>
        <source>&amp;Close</source>
        <translation>S&amp;chließen</translation>
    </message>
    <message>
        <source>Close; the port stays as it is</source>
        <translation>Schließen; der Port bleibt, wie er ist</translation>
    </message>
    <message>
        <source>Or another &amp;path</source>
        <translation>Oder ein anderer &amp;Pfad</translation>
    </message>
    <message>
        <source>&amp;Dialect</source>
        <translation>&amp;Dialekt</translation>
    </message>
    <message>
        <source>Serial ports</source>
        <translation>Serielle Ports</translation>
    </message>
    <message>
        <source>Any name the system opens; a choice in the list fills it in</source>
        <translation>Jeder Name, den das System öffnet; eine Wahl in der Liste trägt ihn ein</translation>
    </message>
    <message>
        <source>How the unit writes its reports; choose one only when it is found wrongly</source>
        <translation>Wie die Einheit ihre Berichte schreibt; nur wählen, wenn es falsch erkannt wird</translation>
    </message>
    <message>
        <source>Ask the unit for its version, number and radio channel</source>
        <translation>Die Einheit nach Version, Nummer und Funkkanal fragen</translation>
    </message>
    <message>
        <source>Use this port and dialect from now on; Undo takes it back</source>
        <translation>Ab jetzt diesen Port und Dialekt verwenden; Rückgängig nimmt es zurück</translation>
    </message>
    <message>
        <source>Port</source>
        <translation>Port</translation>
    </message>
    <message>
        <source>Device</source>
        <translation>Gerät</translation>
    </message>
    <message>
        <source>USB ID</source>
        <translation>USB-ID</translation>
    </message>
    <message>
        <source>Serial number</source>
        <translation>Seriennummer</translation>
    </message>
    <message>
        <source>any</source>
        <translation>beliebig</translation>
    </message>
    <message>
        <source>The first TREK1000 unit that is plugged in</source>
        <translation>Die erste TREK1000-Einheit, die eingesteckt ist</translation>
    </message>
    <message>
        <source>The unit is not connected: choose its port, then open it in the panel Links.</source>
        <translation>Die Einheit ist nicht verbunden: Wählen Sie ihren Port, dann öffnen Sie sie im Feld Verbindungen.</translation>
    </message>
    <message>
        <source>The unit has not told yet what it is.</source>
        <translation>Die Einheit hat noch nicht gesagt, was sie ist.</translation>
    </message>
    <message>
        <source>Unit: %1, number %2, channel %3, %4</source>
        <translation>Einheit: %1, Nummer %2, Kanal %3, %4</translation>
    </message>
    <message>
        <source>6.81 Mb/s</source>
        <translation>6,81 Mb/s</translation>
    </message>
    <message>
        <source>110 kb/s</source>
        <translation>110 kb/s</translation>
    </message>
    <message>
        <source>This computer has no serial port now. Plug the unit in, then list again.</source>
        <translation>Dieser Rechner hat gerade keinen seriellen Port. Stecken Sie die Einheit ein und listen Sie neu auf.</translation>
    </message>
</context>
<context>
    <name>agv::gui::ShiftLog</name>
    <message>
        <source>Sleeptime changed from %1 to %2</source>
        <translation>Sleeptime von %1 auf %2 geändert</translation>
    </message>
    <message>
        <source>Wheel speed of its turns changed from %1 to %2</source>
        <translation>Radgeschwindigkeit seiner Drehungen von %1 auf %2 geändert</translation>
    </message>
</context>
<context>
    <name>agv::gui::ShiftPanel</name>
    <message>
        <source>%1 (%2)</source>
        <translation>%1 (%2)</translation>
    </message>
    <message>
        <source>Start of shift: all %1 checks passed</source>
        <translation>Schichtbeginn: alle %1 Prüfungen bestanden</translation>
    </message>
    <message>
        <source>Start of shift: %1 of %2 checks failed: %3</source>
        <translation>Schichtbeginn: %1 von %2 Prüfungen nicht bestanden: %3</translation>
    </message>
    <message>
        <source>Before the shift: press the button above. Nothing moves.</source>
        <translation>Vor der Schicht: Drücken Sie den Knopf oben. Nichts bewegt sich.</translation>
    </message>
    <message>
        <source>Checking …</source>
        <translation>Prüft …</translation>
    </message>
    <message>
        <source>All %1 checks passed</source>
        <translation>Alle %1 Prüfungen bestanden</translation>
    </message>
    <message>
        <source>%1 of %2 checks failed</source>
        <translation>%1 von %2 Prüfungen nicht bestanden</translation>
    </message>
    <message>
        <source>Ready: all AGVs (%1) were located in %2.</source>
        <translation>Bereit: Alle AGVs (%1) wurden in %2 geortet.</translation>
    </message>
    <message>
        <source>Located in %2: AGV %1. The others could not be calibrated.</source>
        <translation>In %2 geortet: AGV %1. Die anderen konnten nicht kalibriert werden.</translation>
    </message>
    <message>
        <source>Not ready: no AGV was located.</source>
        <translation>Nicht bereit: Kein AGV wurde geortet.</translation>
    </message>
    <message>
        <source>Not ready: located was only AGV %1.</source>
        <translation>Nicht bereit: Geortet wurde nur AGV %1.</translation>
    </message>
    <message>
        <source>Start of shift: %1</source>
        <translation>Schichtbeginn: %1</translation>
    </message>
    <message>
        <source>waits</source>
        <translation>wartet</translation>
    </message>
    <message>
        <source>not calibrated</source>
        <translation>nicht kalibriert</translation>
    </message>
    <message>
        <source>turns …</source>
        <translation>dreht …</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>angehalten</translation>
    </message>
    <message>
        <source>did not start; the event log says why</source>
        <translation>begann nicht; die Ereignisse sagen warum</translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>Calibrate one after the &amp;other</source>
        <translation>&amp;Nacheinander kalibrieren</translation>
    </message>
    <message>
        <source>Calibrate AGV %1 one after the &amp;other</source>
        <translation>AGV %1 &amp;nacheinander kalibrieren</translation>
    </message>
    <message>
        <source>All AGVs (%1) were located in %2, but %3 of the checks failed.</source>
        <translation>Alle AGVs (%1) wurden in %2 geortet, aber %3 der Prüfungen sind nicht bestanden.</translation>
    </message>
</context>
<context>
    <name>agv::gui::ShortcutDialog</name>
    <message>
        <source>Keyboard shortcuts</source>
        <translation>Tastenkürzel</translation>
    </message>
    <message>
        <source>Stop all AGVs, from everywhere</source>
        <translation>Alle AGVs anhalten, von überall</translation>
    </message>
    <message>
        <source>Arrows, +, -</source>
        <translation>Pfeile, +, -</translation>
    </message>
    <message>
        <source>Move and zoom the map that has the focus</source>
        <translation>Die Karte mit dem Fokus verschieben und zoomen</translation>
    </message>
    <message>
        <source>Copy the chosen lines of the event log</source>
        <translation>Die gewählten Zeilen der Ereignisse kopieren</translation>
    </message>
    <message>
        <source>Go to the next field</source>
        <translation>Zum nächsten Feld gehen</translation>
    </message>
    <message>
        <source>Choose AGV 1 to 9</source>
        <translation>AGV 1 bis 9 wählen</translation>
    </message>
    <message>
        <source>Close</source>
        <translation>Schließen</translation>
    </message>
</context>
<context>
    <name>agv::gui::StopFitPlot</name>
    <message>
        <source>No stops to compare yet. Press Calibrate: after the third stop this shows which tags each stop saw, missed or should not have seen.</source>
        <translation>Noch keine Stopps zu vergleichen. Drücken Sie „Kalibrieren“: Nach dem dritten Stopp steht hier, welche Tags jeder Stopp sah, vermisste oder nicht hätte sehen sollen.</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Floor tags</source>
        <translation>Bodentags</translation>
    </message>
    <message>
        <source>seen</source>
        <translation>gesehen</translation>
    </message>
    <message>
        <source>missed</source>
        <translation>vermisst</translation>
    </message>
    <message>
        <source>out of place</source>
        <translation>fehl am Platz</translation>
    </message>
</context>
<context>
    <name>agv::gui::UwbEditor</name>
    <message>
        <source>Choose port %1</source>
        <translation>Port %1 wählen</translation>
    </message>
    <message>
        <source>Add %1</source>
        <translation>%1 hinzufügen</translation>
    </message>
    <message>
        <source>Remove %1</source>
        <translation>%1 entfernen</translation>
    </message>
</context>
<context>
    <name>agv::gui::UwbScreens</name>
    <message>
        <source>All 256 anchor numbers are in use.</source>
        <translation>Alle 256 Ankernummern sind vergeben.</translation>
    </message>
    <message>
        <source>All 256 tag numbers are in use.</source>
        <translation>Alle 256 Tag-Nummern sind vergeben.</translation>
    </message>
    <message>
        <source>Undo: %1</source>
        <translation>Rückgängig: %1</translation>
    </message>
    <message>
        <source>There is nothing to undo</source>
        <translation>Es gibt nichts zurückzunehmen</translation>
    </message>
    <message>
        <source>Redo: %1</source>
        <translation>Wiederholen: %1</translation>
    </message>
    <message>
        <source>There is nothing to redo</source>
        <translation>Es gibt nichts zu wiederholen</translation>
    </message>
    <message>
        <source>UWB anchors</source>
        <translation>UWB-Anker</translation>
    </message>
    <message>
        <source>UWB tags</source>
        <translation>UWB-Tags</translation>
    </message>
    <message>
        <source>No UWB anchors, so UWB is not used. Add them here, or import a list of this or another program.</source>
        <translation>Keine UWB-Anker, also wird UWB nicht verwendet. Fügen Sie sie hier hinzu oder importieren Sie eine Liste dieses oder eines anderen Programms.</translation>
    </message>
    <message>
        <source>No UWB tags. Add the anchors first (panel UWB anchors), then tags; those that are heard come by themselves.</source>
        <translation>Keine UWB-Tags. Fügen Sie erst die Anker hinzu (Feld UWB-Anker), dann Tags; die zu hören sind, kommen von selbst.</translation>
    </message>
    <message>
        <source>No UWB tags: none is listed, and none is heard. Switch a tag on, or add one here.</source>
        <translation>Keine UWB-Tags: Keines ist eingetragen, und keines ist zu hören. Schalten Sie ein Tag ein oder fügen Sie hier eines hinzu.</translation>
    </message>
    <message>
        <source>No UWB tags: none is listed. Open the UWB unit in the panel Links and switch a tag on; it comes by itself. Or add one here.</source>
        <translation>Keine UWB-Tags: Keines ist eingetragen. Öffnen Sie die UWB-Einheit im Feld Verbindungen und schalten Sie ein Tag ein; es kommt von selbst. Oder fügen Sie hier eines hinzu.</translation>
    </message>
    <message>
        <source>Import anchors and tags</source>
        <translation>Anker und Tags importieren</translation>
    </message>
    <message>
        <source>Anchor lists and plant files (*.csv *.xml *.json *.cfg *.txt)</source>
        <translation>Ankerlisten und Anlagendateien (*.csv *.xml *.json *.cfg *.txt)</translation>
    </message>
    <message>
        <source>All files (*)</source>
        <translation>Alle Dateien (*)</translation>
    </message>
    <message>
        <source>Anchor list (*.csv)</source>
        <translation>Ankerliste (*.csv)</translation>
    </message>
    <message>
        <source>Imported: anchors %1, tags %2. Undo takes the import back.</source>
        <translation>Importiert: Anker %1, Tags %2. Rückgängig nimmt den Import zurück.</translation>
    </message>
    <message>
        <source>Unsaved edits</source>
        <translation>Nicht gespeicherte Änderungen</translation>
    </message>
    <message>
        <source>The UWB anchors and tags were edited but not saved to the plant file.</source>
        <translation>Die UWB-Anker und -Tags wurden geändert, aber nicht in der Anlagendatei gespeichert.</translation>
    </message>
    <message>
        <source>&amp;Save and close</source>
        <translation>&amp;Speichern und schließen</translation>
    </message>
    <message>
        <source>&amp;Discard and close</source>
        <translation>&amp;Verwerfen und schließen</translation>
    </message>
    <message>
        <source>Go &amp;back</source>
        <translation>&amp;Zurück</translation>
    </message>
    <message>
        <source>In use, but not saved: lost when the console ends.</source>
        <translation>Gilt schon, ist aber nicht gespeichert: geht mit dem Ende der Konsole verloren.</translation>
    </message>
    <message>
        <source>In use until the console ends: this plant has no file. Export keeps the anchors.</source>
        <translation>Gilt, bis die Konsole endet: Diese Anlage hat keine Datei. Exportieren bewahrt die Anker auf.</translation>
    </message>
    <message>
        <source>Export anchors</source>
        <translation>Anker exportieren</translation>
    </message>
    <message>
        <source>Anchors of DecaRangeRTLS (*.xml)</source>
        <translation>Anker von DecaRangeRTLS (*.xml)</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 versetzen</translation>
    </message>
</context>
<context>
    <name>agv::model::AlarmTableModel</name>
    <message>
        <source>%1 (%2 times)</source>
        <translation>%1 (%2-mal)</translation>
    </message>
    <message>
        <source>Priority</source>
        <translation>Priorität</translation>
    </message>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>What is the matter, and what to do</source>
        <translation>Was ist, und was ist zu tun</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
</context>
<context>
    <name>agv::model::AlarmWords</name>
    <message>
        <source>Low</source>
        <translation>Niedrig</translation>
    </message>
    <message>
        <source>Medium</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>High</source>
        <translation>Hoch</translation>
    </message>
    <message>
        <source>Held back</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>New</source>
        <translation>Neu</translation>
    </message>
    <message>
        <source>Acknowledged</source>
        <translation>Quittiert</translation>
    </message>
    <message>
        <source>Over, new</source>
        <translation>Vorbei, neu</translation>
    </message>
    <message>
        <source>Shelved, %1 left</source>
        <translation>Zurückgestellt, noch %1</translation>
    </message>
    <message>
        <source>Plant</source>
        <translation>Anlage</translation>
    </message>
    <message>
        <source>UWB</source>
        <translation>UWB</translation>
    </message>
    <message>
        <source>Anchor %1</source>
        <translation>Anker %1</translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>It may be moving: its connection was lost while the wheels were turning</source>
        <translation>Es fährt vielleicht: Die Verbindung ging verloren, während sich die Räder drehten</translation>
    </message>
    <message>
        <source>The robot reports an error</source>
        <translation>Der Roboter meldet einen Fehler</translation>
    </message>
    <message>
        <source>No robot can connect</source>
        <translation>Kein Roboter kann sich verbinden</translation>
    </message>
    <message>
        <source>The connection to the robot is disturbed</source>
        <translation>Die Verbindung zum Roboter ist gestört</translation>
    </message>
    <message>
        <source>The connection to the RFID reader is disturbed</source>
        <translation>Die Verbindung zum RFID-Leser ist gestört</translation>
    </message>
    <message>
        <source>The connection to the UWB unit is disturbed</source>
        <translation>Die Verbindung zur UWB-Einheit ist gestört</translation>
    </message>
    <message>
        <source>Its position is doubted</source>
        <translation>Seine Position ist zweifelhaft</translation>
    </message>
    <message>
        <source>The battery is low</source>
        <translation>Die Batterie ist schwach</translation>
    </message>
    <message>
        <source>The anchor does not seem to stand where the list says</source>
        <translation>Der Anker scheint nicht zu stehen, wo die Liste sagt</translation>
    </message>
    <message>
        <source>Nothing has been measured for some way: the position is only predicted</source>
        <translation>Seit einer Strecke wurde nichts gemessen: Die Position ist nur vorhergesagt</translation>
    </message>
    <message>
        <source>%1 floor tags that the last turn should have read were not read</source>
        <translation>%1 Bodentags, die die letzte Drehung hätte lesen müssen, wurden nicht gelesen</translation>
    </message>
    <message>
        <source>The last turn read floor tags that the plant file does not name: %1</source>
        <translation>Die letzte Drehung las Bodentags, die die Anlagendatei nicht nennt: %1</translation>
    </message>
    <message>
        <source>%1 tried to connect and was refused</source>
        <translation>%1 wollte sich verbinden und wurde abgewiesen</translation>
    </message>
    <message>
        <source>Go and look; use the switch of the AGV.</source>
        <translation>Gehen Sie hin und sehen Sie nach; benutzen Sie den Schalter des AGV.</translation>
    </message>
    <message>
        <source>Look at the display of the AGV; switch it off and on again.</source>
        <translation>Sehen Sie auf die Anzeige des AGV; schalten Sie es aus und wieder ein.</translation>
    </message>
    <message>
        <source>End the other program that uses the port, or change the port in the plant file.</source>
        <translation>Beenden Sie das andere Programm, das den Port benutzt, oder ändern Sie den Port in der Anlagendatei.</translation>
    </message>
    <message>
        <source>Is the AGV switched on and in reach of the Wi-Fi?</source>
        <translation>Ist das AGV eingeschaltet und in Reichweite des WLAN?</translation>
    </message>
    <message>
        <source>Has the WeMos bridge power and Wi-Fi? It is tried again by itself.</source>
        <translation>Hat die WeMos-Brücke Strom und WLAN? Es wird von selbst wieder versucht.</translation>
    </message>
    <message>
        <source>Is the UWB unit plugged in and in its report mode?</source>
        <translation>Ist die UWB-Einheit eingesteckt und im Meldebetrieb?</translation>
    </message>
    <message>
        <source>Calibrate the AGV again before it drives.</source>
        <translation>Kalibrieren Sie das AGV neu, bevor es fährt.</translation>
    </message>
    <message>
        <source>Charge it soon; until then it turns more slowly than its sleeptime expects.</source>
        <translation>Laden Sie es bald; bis dahin dreht es langsamer, als seine Sleeptime erwartet.</translation>
    </message>
    <message>
        <source>Put the anchor back, or enter its new place in the list of anchors.</source>
        <translation>Stellen Sie den Anker zurück oder tragen Sie seinen neuen Ort in die Liste der Anker ein.</translation>
    </message>
    <message>
        <source>Drive slowly over floor tags, or calibrate again.</source>
        <translation>Fahren Sie langsam über Bodentags oder kalibrieren Sie neu.</translation>
    </message>
    <message>
        <source>The map marks them with crossed squares: are they there, and whole?</source>
        <translation>Die Karte zeigt sie als durchkreuzte Quadrate: Sind sie da und heil?</translation>
    </message>
    <message>
        <source>The map marks them with question marks: add them to the plant file.</source>
        <translation>Die Karte zeigt sie mit Fragezeichen: Tragen Sie sie in die Anlagendatei ein.</translation>
    </message>
    <message>
        <source>If it is an AGV of this plant, enter its address in the plant file; else find out whose it is.</source>
        <translation>Ist es ein AGV dieser Anlage, tragen Sie seine Adresse in die Anlagendatei ein; sonst finden Sie heraus, wem es gehört.</translation>
    </message>
</context>
<context>
    <name>agv::model::AnchorTableModel</name>
    <message>
        <source>Anchor %1</source>
        <translation>Anker %1</translation>
    </message>
    <message>
        <source>Of the last %1 ranges of %2</source>
        <translation>Aus den letzten %1 Abständen von %2</translation>
    </message>
    <message>
        <source>No range of %1 yet: open the UWB unit and switch a tag on</source>
        <translation>Noch kein Abstand von %1: die UWB-Einheit öffnen und ein Tag einschalten</translation>
    </message>
    <message>
        <source>Too few ranges of %1 with a position yet</source>
        <translation>Noch zu wenige Abstände von %1 mit einer Position</translation>
    </message>
    <message>
        <source>the number of %1</source>
        <translation>die Nummer von %1</translation>
    </message>
    <message>
        <source>There is an anchor %1 already (%2): choose another number.</source>
        <translation>Es gibt schon einen Anker %1 (%2): Wählen Sie eine andere Nummer.</translation>
    </message>
    <message>
        <source>%1 of %2 in mm</source>
        <translation>%1 von %2 in mm</translation>
    </message>
    <message>
        <source>Show %1</source>
        <translation>%1 zeigen</translation>
    </message>
    <message>
        <source>Hide %1</source>
        <translation>%1 verbergen</translation>
    </message>
    <message>
        <source>Move %1</source>
        <translation>%1 versetzen</translation>
    </message>
    <message>
        <source>Renumber %1</source>
        <translation>%1 neu nummerieren</translation>
    </message>
    <message>
        <source>Rename %1</source>
        <translation>%1 umbenennen</translation>
    </message>
    <message>
        <source>No.</source>
        <comment>number of an anchor</comment>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Number of the anchor, as in the reports: 0 to 255</source>
        <translation>Nummer des Ankers, wie in den Berichten: 0 bis 255</translation>
    </message>
    <message>
        <source>Anchor</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>Name on the map and in messages</source>
        <translation>Name auf der Karte und in Meldungen</translation>
    </message>
    <message>
        <source>x (mm)</source>
        <translation>x (mm)</translation>
    </message>
    <message>
        <source>Antenna of the anchor, to the east of the plant&apos;s origin</source>
        <translation>Antenne des Ankers, östlich vom Ursprung der Anlage</translation>
    </message>
    <message>
        <source>y (mm)</source>
        <translation>y (mm)</translation>
    </message>
    <message>
        <source>Antenna of the anchor, to the north of the plant&apos;s origin</source>
        <translation>Antenne des Ankers, nördlich vom Ursprung der Anlage</translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation>z (mm)</translation>
    </message>
    <message>
        <source>Height of the anchor&apos;s antenna above the floor</source>
        <translation>Höhe der Antenne des Ankers über dem Boden</translation>
    </message>
    <message>
        <source>Map</source>
        <translation>Karte</translation>
    </message>
    <message>
        <source>Whether the map shows the anchor; its ranges are used in any case</source>
        <translation>Ob die Karte den Anker zeigt; seine Abstände werden auf jeden Fall verwendet</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Time since the last range</source>
        <translation>Zeit seit dem letzten Abstand</translation>
    </message>
    <message>
        <source>Ranges per second, of all tags</source>
        <translation>Abstände je Sekunde, von allen Tags</translation>
    </message>
    <message>
        <source>Residual (mm)</source>
        <translation>Abweichung (mm)</translation>
    </message>
    <message>
        <source>How much longer its ranges are than the distances to the positions, on average. Far from 0: it stands elsewhere, its view is blocked, or its ranges need a correction</source>
        <translation>Um wie viel länger seine Abstände im Mittel sind als die zu den Positionen. Weit von 0: Er steht woanders, seine Sicht ist verdeckt, oder seine Abstände brauchen eine Korrektur</translation>
    </message>
    <message>
        <source>Spread (mm)</source>
        <translation>Streuung (mm)</translation>
    </message>
    <message>
        <source>Standard deviation of the residuals</source>
        <translation>Standardabweichung der Abweichungen</translation>
    </message>
    <message>
        <source>Notice</source>
        <translation>Hinweis</translation>
    </message>
    <message>
        <source>Why the place of the anchor in the list is doubted</source>
        <translation>Warum der Ort des Ankers in der Liste bezweifelt wird</translation>
    </message>
    <message>
        <source>Rate (1/s)</source>
        <translation>Rate (1/s)</translation>
    </message>
</context>
<context>
    <name>agv::model::CellInput</name>
    <message>
        <source>&quot;%1&quot; is not a number: %2 stays as it was.</source>
        <translation>„%1“ ist keine Zahl: %2 bleibt unverändert.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is out of range: %2 may be from %3 to %4.</source>
        <translation>„%1“ liegt außerhalb des Bereichs: Für %2 gilt %3 bis %4.</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not a whole number: %2 stays as it was.</source>
        <translation>„%1“ ist keine ganze Zahl: %2 bleibt unverändert.</translation>
    </message>
</context>
<context>
    <name>agv::model::CorrectionTableModel</name>
    <message>
        <source>%1 – %2</source>
        <comment>anchor and tag</comment>
        <translation>%1 – %2</translation>
    </message>
    <message>
        <source>%1: added to each measured range, in cm; empty: nothing</source>
        <translation>%1: wird zu jedem gemessenen Abstand addiert, in cm; leer: nichts</translation>
    </message>
    <message>
        <source>the correction %1 in cm</source>
        <translation>die Korrektur %1 in cm</translation>
    </message>
    <message>
        <source>Correct %1</source>
        <translation>%1 korrigieren</translation>
    </message>
    <message>
        <source>%1 (cm)</source>
        <comment>correction of this tag</comment>
        <translation>%1 (cm)</translation>
    </message>
</context>
<context>
    <name>agv::model::EventTableModel</name>
    <message>
        <source>Time</source>
        <translation>Zeit</translation>
    </message>
    <message>
        <source>Level</source>
        <translation>Stufe</translation>
    </message>
    <message>
        <source>Source</source>
        <translation>Quelle</translation>
    </message>
    <message>
        <source>Text</source>
        <translation>Text</translation>
    </message>
    <message>
        <source>%1 (%2 times, last at %3)</source>
        <translation>%1 (%2-mal, zuletzt um %3)</translation>
    </message>
</context>
<context>
    <name>agv::model::FloorTagTableModel</name>
    <message>
        <source>Not read</source>
        <translation>Nicht gelesen</translation>
    </message>
    <message>
        <source>Read now</source>
        <translation>Jetzt gelesen</translation>
    </message>
    <message>
        <source>Read before</source>
        <translation>Früher gelesen</translation>
    </message>
    <message>
        <source>Missing</source>
        <translation>Fehlt</translation>
    </message>
    <message>
        <source>Unknown</source>
        <translation>Unbekannt</translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>Number</source>
        <translation>Nummer</translation>
    </message>
    <message>
        <source>Short</source>
        <translation>Kurz</translation>
    </message>
    <message>
        <source>UID</source>
        <translation>UID</translation>
    </message>
    <message>
        <source>x</source>
        <translation>x</translation>
    </message>
    <message>
        <source>y</source>
        <translation>y</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Read by</source>
        <translation>Gelesen von</translation>
    </message>
    <message>
        <source>RSSI, steps</source>
        <translation>RSSI, Stufen</translation>
    </message>
    <message>
        <source>Last read</source>
        <translation>Zuletzt gelesen</translation>
    </message>
</context>
<context>
    <name>agv::model::LinkTableModel</name>
    <message>
        <source>AGV %1 RFID</source>
        <translation>AGV %1 RFID</translation>
    </message>
    <message>
        <source>AGV %1 robot</source>
        <translation>AGV %1 Roboter</translation>
    </message>
    <message>
        <source>Address: %1</source>
        <translation>Adresse: %1</translation>
    </message>
    <message>
        <source>Received: %1 messages</source>
        <translation>Empfangen: %1 Nachrichten</translation>
    </message>
    <message>
        <source>Dropped: none</source>
        <translation>Verworfen: keine</translation>
    </message>
    <message>
        <source>Dropped: %1</source>
        <translation>Verworfen: %1</translation>
    </message>
    <message>
        <source>Messages that could not be used; hover a row for the reasons</source>
        <translation>Nachrichten, die nicht brauchbar waren; die Gründe zeigt der Mauszeiger über der Zeile</translation>
    </message>
    <message>
        <source>Connection</source>
        <translation>Verbindung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>in %1</source>
        <comment>time until the next try</comment>
        <translation>in %1</translation>
    </message>
    <message>
        <source>%1 ago</source>
        <comment>age of the last message</comment>
        <translation>vor %1</translation>
    </message>
    <message>
        <source>Messages per second, and the age of the last one</source>
        <translation>Nachrichten je Sekunde und das Alter der letzten</translation>
    </message>
    <message>
        <source>Rate, age</source>
        <translation>Rate</translation>
    </message>
    <message>
        <source>Dropped</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>UWB</source>
        <translation>UWB</translation>
    </message>
    <message>
        <source>UWB (%1)</source>
        <translation>UWB (%1)</translation>
    </message>
    <message>
        <source>Dialect: %1, as the plant file says</source>
        <translation>Dialekt: %1, laut Anlagendatei</translation>
    </message>
    <message>
        <source>Dialect: %1, found from the reports</source>
        <translation>Dialekt: %1, an den Meldungen erkannt</translation>
    </message>
    <message>
        <source>Unit: %1, number %2, channel %3, %4</source>
        <translation>Einheit: %1, Nummer %2, Kanal %3, %4</translation>
    </message>
    <message>
        <source>6.81 Mb/s</source>
        <translation>6,81 Mb/s</translation>
    </message>
    <message>
        <source>110 kb/s</source>
        <translation>110 kb/s</translation>
    </message>
    <message>
        <source>Exchanges missed: %1</source>
        <translation>Verpasste Messungen: %1</translation>
    </message>
</context>
<context>
    <name>agv::model::Messages</name>
    <message>
        <source>Listening for robots on %1 (TCP), %2 (UDP)</source>
        <translation>Roboter können sich verbinden: %1 (TCP), %2 (UDP)</translation>
    </message>
    <message>
        <source>Listening for robots on %1 (TCP), no telemetry</source>
        <translation>Roboter können sich verbinden: %1 (TCP), ohne Telemetrie</translation>
    </message>
    <message>
        <source>%1 (TCP), no telemetry</source>
        <translation>%1 (TCP), ohne Telemetrie</translation>
    </message>
    <message>
        <source>Not listening yet</source>
        <translation>noch nicht bereit</translation>
    </message>
    <message>
        <source>Not listening: %1</source>
        <translation>nicht bereit: %1</translation>
    </message>
    <message>
        <source>All AGVs were told to stop: %1</source>
        <translation>Alle AGVs wurden angehalten: %1</translation>
    </message>
    <message>
        <source>Stop all was pressed</source>
        <translation>„Alle anhalten“ wurde gedrückt</translation>
    </message>
    <message>
        <source>The operator aborted it</source>
        <translation>Vom Bediener abgebrochen</translation>
    </message>
    <message>
        <source>The console ends</source>
        <translation>Die Konsole wird beendet</translation>
    </message>
    <message>
        <source>%1 tried to connect as a robot and was refused: it is not in the plant file</source>
        <translation>%1 wollte sich als Roboter verbinden und wurde abgewiesen: Die Adresse steht nicht in der Anlagendatei</translation>
    </message>
    <message>
        <source>There is no AGV %1 in the plant file</source>
        <translation>In der Anlagendatei gibt es kein AGV %1</translation>
    </message>
    <message>
        <source>The initialisation turn was not started: %1</source>
        <translation>Die Initialisierungsdrehung wurde nicht begonnen: %1</translation>
    </message>
    <message>
        <source>Initialisation turn started</source>
        <translation>Initialisierungsdrehung begonnen</translation>
    </message>
    <message>
        <source>a turn is running</source>
        <translation>Es läuft schon eine Drehung</translation>
    </message>
    <message>
        <source>the robot is not connected</source>
        <translation>Der Roboter ist nicht verbunden</translation>
    </message>
    <message>
        <source>the RFID reader is not connected</source>
        <translation>Der RFID-Leser ist nicht verbunden</translation>
    </message>
    <message>
        <source>the robot is docked: undock it first</source>
        <translation>Der Roboter ist angedockt: erst abdocken</translation>
    </message>
    <message>
        <source>the robot is in error: look at the robot, then switch it off and on</source>
        <translation>Der Roboter meldet einen Fehler: nach dem Roboter sehen, dann aus- und einschalten</translation>
    </message>
    <message>
        <source>there is no finished turn</source>
        <translation>Es gibt keine abgeschlossene Drehung</translation>
    </message>
    <message>
        <source>Stop %1 is not read again: %2</source>
        <translation>Stopp %1 wird nicht neu gelesen: %2</translation>
    </message>
    <message>
        <source>The sleeptime was not changed: %1</source>
        <translation>Die Sleeptime wurde nicht geändert: %1</translation>
    </message>
    <message>
        <source>The robot connected a second time from %1; its older connection was closed</source>
        <translation>Der Roboter hat sich von %1 ein zweites Mal verbunden; die ältere Verbindung wurde geschlossen</translation>
    </message>
    <message>
        <source>the robot connected anew, it may have restarted</source>
        <translation>Der Roboter hat sich neu verbunden, vielleicht ist er neu gestartet</translation>
    </message>
    <message>
        <source>The robot connected from %1</source>
        <translation>Der Roboter hat sich von %1 verbunden</translation>
    </message>
    <message>
        <source>THE ROBOT MAY STILL BE MOVING: its link was lost while it drove. Use its own switch. (%1)</source>
        <translation>DER ROBOTER FÄHRT MÖGLICHERWEISE NOCH: Die Verbindung brach während der Fahrt ab. Am Roboter ausschalten. (%1)</translation>
    </message>
    <message>
        <source>The link to the robot was lost: %1</source>
        <translation>Die Verbindung zum Roboter ist verloren: %1</translation>
    </message>
    <message>
        <source>The link to the RFID reader was lost: %1</source>
        <translation>Die Verbindung zum RFID-Leser ist verloren: %1</translation>
    </message>
    <message>
        <source>it was closed</source>
        <translation>Sie wurde geschlossen</translation>
    </message>
    <message>
        <source>a command could not be sent</source>
        <translation>Ein Befehl ließ sich nicht senden</translation>
    </message>
    <message>
        <source>Connected</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>%1 more messages were left out</source>
        <translation>%1 weitere Meldungen weggelassen</translation>
    </message>
    <message>
        <source>The robot is docking</source>
        <translation>Der Roboter dockt an</translation>
    </message>
    <message>
        <source>The robot is docking to charge</source>
        <translation>Der Roboter dockt zum Laden an</translation>
    </message>
    <message>
        <source>The robot is docked</source>
        <translation>Der Roboter ist angedockt</translation>
    </message>
    <message>
        <source>The robot is undocking</source>
        <translation>Der Roboter dockt ab</translation>
    </message>
    <message>
        <source>The robot is idle</source>
        <translation>Der Roboter ist bereit</translation>
    </message>
    <message>
        <source>The robot is in error: look at the robot, then switch it off and on</source>
        <translation>Der Roboter meldet einen Fehler: nach dem Roboter sehen, dann aus- und einschalten</translation>
    </message>
    <message>
        <source>The robot&apos;s program failed at %1, line %2</source>
        <translation>Das Programm des Roboters ist gescheitert: %1, Zeile %2</translation>
    </message>
    <message>
        <source>Connected, but nothing heard for 5 s</source>
        <translation>Verbunden, aber seit 5 s nichts gehört</translation>
    </message>
    <message>
        <source>Waiting for the robot to connect: switch it on</source>
        <translation>Warten auf den Roboter: schalten Sie ihn ein</translation>
    </message>
    <message>
        <source>Stop %1 is read again</source>
        <translation>Stopp %1 wird neu gelesen</translation>
    </message>
    <message>
        <source>No floor tag was read for %1 s: check the RFID reader and that the AGV stands on tags</source>
        <translation>Seit %1 s wurde kein Bodentag gelesen: RFID-Leser prüfen, und ob das AGV auf Tags steht</translation>
    </message>
    <message>
        <source>No floor tag was read at stop %1</source>
        <translation>An Stopp %1 wurde kein Bodentag gelesen</translation>
    </message>
    <message>
        <source>The robot did not report the end of its turn in time: check that its wheels are free</source>
        <translation>Der Roboter hat das Ende seiner Drehung nicht rechtzeitig gemeldet: prüfen, ob die Räder frei sind</translation>
    </message>
    <message>
        <source>The solver gave no answer</source>
        <translation>Der Löser gab keine Antwort</translation>
    </message>
    <message>
        <source>The robot reports an error: look at the robot, then switch it off and on</source>
        <translation>Der Roboter meldet einen Fehler: nach dem Roboter sehen, dann aus- und einschalten</translation>
    </message>
    <message>
        <source>The robot is docking or docked: undock it first</source>
        <translation>Der Roboter dockt an oder ist angedockt: erst abdocken</translation>
    </message>
    <message>
        <source>The robot stopped in the middle of a turn: look for what it bumped into</source>
        <translation>Der Roboter blieb mitten in der Drehung stehen: nachsehen, woran er gestoßen ist</translation>
    </message>
    <message>
        <source>The robot was stopped %1 ms late: this computer was busy, the step is about %2 degrees too long</source>
        <translation>Der Roboter wurde %1 ms zu spät angehalten: Dieser Rechner war ausgelastet, der Schritt ist etwa %2 Grad zu lang</translation>
    </message>
    <message>
        <source>Number of stops is %1: it must be 8, 12 or 16</source>
        <translation>Die Zahl der Stopps ist %1: erlaubt sind 8, 12 oder 16</translation>
    </message>
    <message>
        <source>%1 is %2: it must lie between %3 and %4</source>
        <translation>%1 ist %2: erlaubt ist %3 bis %4</translation>
    </message>
    <message>
        <source>Wheel speed</source>
        <translation>Radgeschwindigkeit</translation>
    </message>
    <message>
        <source>Settling time</source>
        <translation>Beruhigungszeit</translation>
    </message>
    <message>
        <source>Shortest dwell</source>
        <translation>Kürzestes Verweilen</translation>
    </message>
    <message>
        <source>Longest dwell</source>
        <translation>Längstes Verweilen</translation>
    </message>
    <message>
        <source>Connected again, but still nothing is heard: no floor tag below the antenna, or the reader has no power</source>
        <translation>Wieder verbunden, aber es kommt noch nichts: kein Bodentag unter der Antenne, oder der Leser hat keinen Strom</translation>
    </message>
    <message>
        <source>No answer within %1 s: check the address and that the device has power and Wi-Fi</source>
        <translation>Keine Antwort innerhalb von %1 s: Adresse prüfen, und ob das Gerät Strom und WLAN hat</translation>
    </message>
    <message>
        <source>Connected, but nothing heard for %1 s: no floor tag below the antenna, or the link is dead</source>
        <translation>Verbunden, aber seit %1 s nichts gehört: kein Bodentag unter der Antenne, oder die Verbindung ist tot</translation>
    </message>
    <message>
        <source>Nothing heard for %1 s: the connection is being made anew</source>
        <translation>Seit %1 s nichts gehört: Die Verbindung wird neu aufgebaut</translation>
    </message>
    <message>
        <source>%1 refuses the connection: the device is on, but nothing listens on that port; check the port</source>
        <translation>%1 weist die Verbindung ab: Das Gerät ist an, aber an diesem Port antwortet nichts; Port prüfen</translation>
    </message>
    <message>
        <source>%1 closed the connection: it was switched off, restarted or serves other clients already</source>
        <translation>%1 hat die Verbindung geschlossen: ausgeschaltet, neu gestartet oder schon mit anderen verbunden</translation>
    </message>
    <message>
        <source>%1 closed the connection: it was switched off or restarted</source>
        <translation>%1 hat die Verbindung geschlossen: ausgeschaltet oder neu gestartet</translation>
    </message>
    <message>
        <source>The host &quot;%1&quot; is not known: check the name in the plant file</source>
        <translation>Der Rechnername „%1“ ist nicht bekannt: Namen in der Anlagendatei prüfen</translation>
    </message>
    <message>
        <source>%1 no longer answers: check its power and its Wi-Fi</source>
        <translation>%1 antwortet nicht mehr: Strom und WLAN des Geräts prüfen</translation>
    </message>
    <message>
        <source>%1 does not answer: check the address, its power and its Wi-Fi</source>
        <translation>%1 antwortet nicht: Adresse, Strom und WLAN des Geräts prüfen</translation>
    </message>
    <message>
        <source>%1 cannot be reached (%2): check the cable, the Wi-Fi and the address</source>
        <translation>%1 ist nicht erreichbar (%2): Kabel, WLAN und Adresse prüfen</translation>
    </message>
    <message>
        <source>The system forbids a connection to %1: check the firewall</source>
        <translation>Das System verbietet die Verbindung zu %1: Firewall prüfen</translation>
    </message>
    <message>
        <source>Connection to %1 failed: %2</source>
        <translation>Verbindung zu %1 gescheitert: %2</translation>
    </message>
    <message>
        <source>%1 is in use: another console or program holds it; end that program or change the port in the plant file</source>
        <translation>%1 ist belegt: Eine andere Konsole oder ein anderes Programm benutzt ihn; beenden Sie es oder ändern Sie den Port in der Anlagendatei</translation>
    </message>
    <message>
        <source>%1 is forbidden by the system: ports below 1024 need administrator rights; choose a higher port in the plant file</source>
        <translation>%1 ist vom System gesperrt: Ports unter 1024 brauchen Verwalterrechte; wählen Sie in der Anlagendatei einen höheren</translation>
    </message>
    <message>
        <source>%1 does not exist: this computer has no network interface with that address; check the listen address in the plant file</source>
        <translation>%1 gibt es nicht: Dieser Rechner hat keine Netzschnittstelle mit dieser Adresse; prüfen Sie die eigene Adresse in der Anlagendatei</translation>
    </message>
    <message>
        <source>%1 cannot be opened: %2</source>
        <translation>%1 lässt sich nicht öffnen: %2</translation>
    </message>
    <message>
        <source>%1 port %2 on %3</source>
        <translation>%1-Port %2 auf %3</translation>
    </message>
    <message>
        <source>&quot;%1&quot; is not an address: the listen address of the plant file must be one of this computer, such as 127.0.0.1</source>
        <translation>„%1“ ist keine Adresse: Die eigene Adresse in der Anlagendatei muss eine dieses Rechners sein, etwa 127.0.0.1</translation>
    </message>
    <message>
        <source>The simulated plant could not be started: %1</source>
        <translation>Die simulierte Anlage ließ sich nicht starten: %1</translation>
    </message>
    <message>
        <source>The simulated plant ended unexpectedly (exit status %1)</source>
        <translation>Die simulierte Anlage endete unerwartet (Status %1)</translation>
    </message>
    <message>
        <source>The simulated plant was ended by signal %1</source>
        <translation>Die simulierte Anlage wurde durch Signal %1 beendet</translation>
    </message>
    <message>
        <source>Console</source>
        <translation>Konsole</translation>
    </message>
    <message>
        <source>RFID reader %1</source>
        <translation>RFID-Leser %1</translation>
    </message>
    <message>
        <source>Robot %1</source>
        <translation>Roboter %1</translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>%1 unknown type</source>
        <translation>%1 unbekannter Art</translation>
    </message>
    <message>
        <source>%1 unknown message</source>
        <translation>%1 unbekannte Meldung</translation>
    </message>
    <message>
        <source>%1 bad length</source>
        <translation>%1 falsche Länge</translation>
    </message>
    <message>
        <source>%1 bad value</source>
        <translation>%1 falscher Wert</translation>
    </message>
    <message>
        <source>%1 empty</source>
        <translation>%1 leer</translation>
    </message>
    <message>
        <source>%1 noise</source>
        <translation>%1 Rauschen</translation>
    </message>
    <message>
        <source>%1 bad UID</source>
        <translation>%1 falsche UID</translation>
    </message>
    <message>
        <source>%1 bad RSSI</source>
        <translation>%1 falscher RSSI</translation>
    </message>
    <message>
        <source>%1 truncated</source>
        <translation>%1 abgeschnitten</translation>
    </message>
    <message>
        <source>%1 trailing text</source>
        <translation>%1 mit Anhang</translation>
    </message>
    <message>
        <source>%1 over-long</source>
        <translation>%1 zu lang</translation>
    </message>
    <message>
        <source>%1 bad tag count</source>
        <translation>%1 falsche Tag-Zahl</translation>
    </message>
    <message>
        <source>%1 sent telemetry that was ignored: the plant file has no robot with that address, or more than one</source>
        <translation>%1 sandte Telemetrie, die nicht beachtet wird: Die Anlagendatei hat keinen Roboter mit dieser Adresse oder mehr als einen</translation>
    </message>
    <message>
        <source>The robot is driving</source>
        <translation>Der Roboter fährt</translation>
    </message>
    <message>
        <source>The robot is driving a segment</source>
        <translation>Der Roboter fährt ein Segment</translation>
    </message>
    <message>
        <source>The robot is waiting for a segment</source>
        <translation>Der Roboter wartet auf ein Segment</translation>
    </message>
    <message>
        <source>The wheel speed was not changed: %1</source>
        <translation>Die Radgeschwindigkeit wurde nicht geändert: %1</translation>
    </message>
    <message>
        <source>Sleeptime %1 ms is written to %2; there it was %3 ms</source>
        <translation>Sleeptime %1 ms ist in %2 geschrieben; dort stand %3 ms</translation>
    </message>
    <message>
        <source>The sleeptime holds for this session only: %1</source>
        <translation>Die Sleeptime gilt nur für diese Sitzung: %1</translation>
    </message>
    <message>
        <source>the plant is simulated</source>
        <translation>Die Anlage ist simuliert</translation>
    </message>
    <message>
        <source>there is no plant file</source>
        <translation>Es gibt keine Anlagendatei</translation>
    </message>
    <message>
        <source>Connected again, but still nothing is heard: no UWB tag is switched on or in reach, or the unit hangs</source>
        <translation>Wieder verbunden, aber noch immer ist nichts zu hören: Kein UWB-Tag ist eingeschaltet oder in Reichweite, oder die Einheit hängt</translation>
    </message>
    <message>
        <source>Connected, but nothing heard for %1 s: no UWB tag is switched on or in reach</source>
        <translation>Verbunden, aber seit %1 s ist nichts zu hören: Kein UWB-Tag ist eingeschaltet oder in Reichweite</translation>
    </message>
    <message>
        <source>No answer within %1 s: unplug the unit and plug it in again</source>
        <translation>Keine Antwort innerhalb von %1 s: die Einheit abziehen und wieder einstecken</translation>
    </message>
    <message>
        <source>The port is not the one of a TREK1000 unit (USB id 0483:5740): nothing is sent to it unless you ask for it</source>
        <translation>Die Schnittstelle ist nicht die einer TREK1000-Einheit (USB-Kennung 0483:5740): Ohne Aufforderung wird nichts an sie gesendet</translation>
    </message>
    <message>
        <source>The reports are those of a clone (%1): nothing is sent to it unless you ask for it</source>
        <translation>Die Meldungen sind die eines Nachbaus (%1): Ohne Aufforderung wird nichts an ihn gesendet</translation>
    </message>
    <message>
        <source>The unit did not tell its version and configuration: the age of its ranges is measured from its reports instead</source>
        <translation>Die Einheit hat Version und Einstellung nicht genannt: Das Alter ihrer Abstände wird stattdessen aus ihren Meldungen bestimmt</translation>
    </message>
    <message>
        <source>The unit is %1: %2 %3, channel %4, %5</source>
        <translation>Die Einheit ist %1: %2 %3, Kanal %4, %5</translation>
    </message>
    <message>
        <source>anchor</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>tag</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>listener</source>
        <translation>Mithörer</translation>
    </message>
    <message>
        <source>Not heard for %1 s: the tag is off or out of reach</source>
        <translation>Seit %1 s nicht gehört: Das Tag ist aus oder außer Reichweite</translation>
    </message>
    <message>
        <source>Anchor %1 measures this tag, but is not in the plant file: enter where it is</source>
        <translation>Anker %1 misst dieses Tag, steht aber nicht in der Anlagendatei: dort eintragen, wo er ist</translation>
    </message>
    <message>
        <source>Anchor %1 is not in the list: enter its height to have it placed</source>
        <translation>Anker %1 steht nicht in der Liste: seine Höhe eingeben, damit sein Ort bestimmt wird</translation>
    </message>
    <message>
        <source>Anchor %1 has no ranges to the others and stays where it is</source>
        <translation>Anker %1 hat keine Abstände zu den anderen und bleibt, wo er ist</translation>
    </message>
    <message>
        <source>Anchor %1 has too few ranges to the others to be placed and stays where it is</source>
        <translation>Anker %1 hat zu wenige Abstände zu den anderen, um seinen Ort zu bestimmen, und bleibt, wo er ist</translation>
    </message>
    <message>
        <source>More than one arrangement fits the ranges and the one nearest to the list was taken: look whether it is right, the range between anchors %1 and %2 would tell</source>
        <translation>Mehr als eine Anordnung passt zu den Abständen, gewählt ist die der Liste nächste: prüfen, ob sie stimmt; der Abstand zwischen den Ankern %1 und %2 würde es zeigen</translation>
    </message>
    <message>
        <source>The range between anchors %1 and %2 is %3 mm too long: look for what stands between them</source>
        <translation>Der Abstand zwischen den Ankern %1 und %2 ist %3 mm zu lang: nachsehen, was zwischen ihnen steht</translation>
    </message>
    <message>
        <source>The range between anchors %1 and %2 is %3 mm too short: look for what stands between them</source>
        <translation>Der Abstand zwischen den Ankern %1 und %2 ist %3 mm zu kurz: nachsehen, was zwischen ihnen steht</translation>
    </message>
    <message>
        <source>The range between anchors %1 and %2 (%3 mm) is shorter than the difference of their heights (%4 mm): correct the heights in the list</source>
        <translation>Der Abstand zwischen den Ankern %1 und %2 (%3 mm) ist kürzer als der Unterschied ihrer Höhen (%4 mm): die Höhen in der Liste berichtigen</translation>
    </message>
    <message>
        <source>There is no anchor in the list: enter the anchors with their heights first</source>
        <translation>Es steht kein Anker in der Liste: zuerst die Anker mit ihren Höhen eingeben</translation>
    </message>
    <message>
        <source>No ranges between the anchors were heard: switch the anchors on and connect the unit that is anchor 0</source>
        <translation>Es wurden keine Abstände zwischen den Ankern empfangen: die Anker einschalten und die Einheit anschließen, die Anker 0 ist</translation>
    </message>
    <message>
        <source>Too few pairs of anchors range with each other: three anchors that all see each other are needed</source>
        <translation>Zu wenige Ankerpaare messen miteinander: Es braucht drei Anker, die einander alle sehen</translation>
    </message>
    <message>
        <source>The anchors stand nearly on one line: their ranges do not tell how far beside it; move one of them aside</source>
        <translation>Die Anker stehen fast auf einer Linie: Ihre Abstände sagen nicht, wie weit daneben; einen davon zur Seite stellen</translation>
    </message>
    <message>
        <source>The ranges between the anchors fit no arrangement: look for what hides the anchors from each other</source>
        <translation>Die Abstände zwischen den Ankern passen zu keiner Anordnung: nachsehen, was die Anker voreinander verdeckt</translation>
    </message>
    <message>
        <source>Only %1 of the 3 ranges that a position needs: look for what hides the anchors</source>
        <translation>Nur %1 der 3 Abstände, die eine Position braucht: nachsehen, was die Anker verdeckt</translation>
    </message>
    <message>
        <source>The ranges fit no position: check the anchors&apos; places in the plant file</source>
        <translation>Die Abstände passen zu keiner Position: die Orte der Anker in der Anlagendatei prüfen</translation>
    </message>
    <message>
        <source>There is no anchor in the list: enter where the anchors are</source>
        <translation>Die Liste enthält keinen Anker: eintragen, wo die Anker sind</translation>
    </message>
    <message>
        <source>The place of the tag is not known: enter where it stands</source>
        <translation>Der Ort des Tags ist nicht bekannt: eintragen, wo es steht</translation>
    </message>
    <message>
        <source>The time of a calibration must lie between %1 and %2 s: choose another</source>
        <translation>Die Dauer einer Kalibrierung muss zwischen %1 und %2 s liegen: eine andere wählen</translation>
    </message>
    <message>
        <source>No anchor measured tag %1 %2 times: bring it nearer to the anchors or take longer</source>
        <translation>Kein Anker hat Tag %1 mindestens %2-mal gemessen: näher an die Anker bringen oder länger messen</translation>
    </message>
    <message>
        <source>Tag %1 was not heard: switch it on and look whether the anchors are in reach</source>
        <translation>Tag %1 wurde nicht gehört: einschalten und prüfen, ob die Anker in Reichweite sind</translation>
    </message>
    <message>
        <source>The ranges of anchor %1 are wrong by %2 mm: check the places of the tag and the anchor before you use the offset</source>
        <translation>Die Abstände von Anker %1 sind um %2 mm falsch: die Orte von Tag und Anker prüfen, bevor die Korrektur übernommen wird</translation>
    </message>
    <message>
        <source>The ranges of anchor %1 scatter by %2 mm: look for what hides it, keep the tag still and calibrate again</source>
        <translation>Die Abstände von Anker %1 streuen um %2 mm: nachsehen, was ihn verdeckt, das Tag still halten und neu kalibrieren</translation>
    </message>
    <message>
        <source>Anchors without an offset, because they measured the tag fewer than %1 times: %2</source>
        <translation>Anker ohne Korrektur, weil sie das Tag weniger als %1-mal gemessen haben: %2</translation>
    </message>
    <message>
        <source>The anchors were changed meanwhile: start the calibration again</source>
        <translation>Die Anker wurden inzwischen geändert: die Kalibrierung neu beginnen</translation>
    </message>
    <message>
        <source>Ranges fit a place %1 mm from the one in the list: measure the anchor again or restore it</source>
        <translation>Die Abstände passen zu einem Ort %1 mm neben dem in der Liste: den Anker neu einmessen oder zurückstellen</translation>
    </message>
    <message>
        <source>Ranges are %1 mm too long: the anchor may have been moved or be hidden; look at it</source>
        <translation>Die Abstände sind %1 mm zu lang: Der Anker ist vielleicht verstellt oder verdeckt; nachsehen</translation>
    </message>
    <message>
        <source>Ranges are %1 mm too short: the anchor may have been moved; measure it again or calibrate its ranges</source>
        <translation>Die Abstände sind %1 mm zu kurz: Der Anker ist vielleicht verstellt; neu einmessen oder seine Abstände kalibrieren</translation>
    </message>
    <message>
        <source>Anchor %1: %2</source>
        <translation>Anker %1: %2</translation>
    </message>
    <message>
        <source>There is no serial port %1: plug the unit in, or choose another port</source>
        <translation>Die serielle Schnittstelle %1 gibt es nicht: die Einheit einstecken oder eine andere Schnittstelle wählen</translation>
    </message>
    <message>
        <source>Serial port %1 is in use: another console, terminal or program holds it; end that program</source>
        <translation>Die serielle Schnittstelle %1 ist belegt: Eine andere Konsole, ein Terminal oder Programm hält sie; dieses Programm beenden</translation>
    </message>
    <message>
        <source>You may not open the serial port %1: install the udev rule %2</source>
        <translation>Sie dürfen die serielle Schnittstelle %1 nicht öffnen: die udev-Regel %2 einrichten</translation>
    </message>
    <message>
        <source>You may not open the serial port %1: join the group %2 (sudo usermod -aG %3 $USER, then log in anew) or install the udev rule %4</source>
        <translation>Sie dürfen die serielle Schnittstelle %1 nicht öffnen: der Gruppe %2 beitreten (sudo usermod -aG %3 $USER, dann neu anmelden) oder die udev-Regel %4 einrichten</translation>
    </message>
    <message>
        <source>%1 is no serial port: choose another port</source>
        <translation>%1 ist keine serielle Schnittstelle: eine andere wählen</translation>
    </message>
    <message>
        <source>Serial port %1 is gone: the unit was unplugged or lost its power; plug it in again</source>
        <translation>Die serielle Schnittstelle %1 ist weg: Die Einheit wurde abgezogen oder hat keinen Strom; sie wieder einstecken</translation>
    </message>
    <message>
        <source>Serial port %1 failed: %2</source>
        <translation>Die serielle Schnittstelle %1 ist ausgefallen: %2</translation>
    </message>
    <message>
        <source>USB %1, serial number %2</source>
        <translation>USB %1, Seriennummer %2</translation>
    </message>
    <message>
        <source>UWB</source>
        <translation>UWB</translation>
    </message>
    <message>
        <source>%1 bad field</source>
        <translation>%1 falsches Feld</translation>
    </message>
    <message>
        <source>Left out: %1 more</source>
        <translation>Weggelassen: %1 weitere</translation>
    </message>
    <message>
        <source>Left out: %1</source>
        <translation>Weggelassen: %1</translation>
    </message>
    <message>
        <source>The file has no heights: the new tags have %1 mm until you enter their own</source>
        <translation>Die Datei hat keine Höhen: Die neuen Tags haben %1 mm, bis Sie ihre eigene eingeben</translation>
    </message>
    <message>
        <source>Anchors and the corrections of the tags 0 to 7 are written to %1</source>
        <translation>Die Anker und die Korrekturen der Tags 0 bis 7 stehen in %1</translation>
    </message>
    <message>
        <source>Anchors are written to %1; tags and corrections have no place in that format</source>
        <translation>Die Anker stehen in %1; für Tags und Korrekturen hat dieses Format keinen Platz</translation>
    </message>
    <message>
        <source>Saved to %1</source>
        <translation>Gespeichert in %1</translation>
    </message>
    <message>
        <source>Not saved: %1</source>
        <translation>Nicht gespeichert: %1</translation>
    </message>
    <message>
        <source>Its pose is doubted. %1</source>
        <translation>Seine Pose ist zweifelhaft. %1</translation>
    </message>
    <message>
        <source>The floor tags it reads lie elsewhere: it was moved or slipped; calibrate it again</source>
        <translation>Die Bodentags, die es liest, liegen anderswo: Es wurde bewegt oder ist gerutscht; neu kalibrieren</translation>
    </message>
    <message>
        <source>Its UWB tag is elsewhere: it was moved; calibrate it again</source>
        <translation>Sein UWB-Tag ist anderswo: Es wurde bewegt; neu kalibrieren</translation>
    </message>
    <message>
        <source>It drove by itself to dock or undock: calibrate it again</source>
        <translation>Es ist zum An- oder Abdocken selbst gefahren: neu kalibrieren</translation>
    </message>
    <message>
        <source>The link to the robot was lost while it drove: calibrate it again</source>
        <translation>Die Verbindung zum Roboter riss ab, während er fuhr: neu kalibrieren</translation>
    </message>
    <message>
        <source>Nothing measured for the last %1 mm of its way: the pose is what the commanded speeds make of it</source>
        <translation>Auf den letzten %1 mm seines Wegs wurde nichts gemessen: Die Pose folgt nur aus den befohlenen Geschwindigkeiten</translation>
    </message>
    <message>
        <source>It was told to stop</source>
        <translation>Es wurde angehalten</translation>
    </message>
    <message>
        <source>It was told to %1</source>
        <translation>Auftrag an das AGV: %1</translation>
    </message>
    <message>
        <source>It does not drive: %1</source>
        <translation>Es fährt nicht: %1</translation>
    </message>
    <message>
        <source>It does not dock: %1</source>
        <translation>Es dockt nicht an: %1</translation>
    </message>
    <message>
        <source>It does not undock: %1</source>
        <translation>Es dockt nicht ab: %1</translation>
    </message>
    <message>
        <source>It does not dock to charge: %1</source>
        <translation>Es dockt nicht zum Laden an: %1</translation>
    </message>
    <message>
        <source>Stopped: %1</source>
        <translation>Angehalten: %1</translation>
    </message>
    <message>
        <source>Driving by hand ended: %1</source>
        <translation>Ende der Handfahrt: %1</translation>
    </message>
    <message>
        <source>Driven by hand, with the keys</source>
        <translation>Handfahrt mit den Tasten</translation>
    </message>
    <message>
        <source>Driven by hand, with the pad</source>
        <translation>Handfahrt mit dem Fahrfeld</translation>
    </message>
    <message>
        <source>Stop was pressed</source>
        <translation>„Anhalten“ wurde gedrückt</translation>
    </message>
    <message>
        <source>dock</source>
        <translation>andocken</translation>
    </message>
    <message>
        <source>undock</source>
        <translation>abdocken</translation>
    </message>
    <message>
        <source>dock to charge</source>
        <translation>zum Laden andocken</translation>
    </message>
    <message>
        <source>the operator let go</source>
        <translation>der Bediener hat losgelassen</translation>
    </message>
    <message>
        <source>the keyboard went elsewhere</source>
        <translation>die Tastatur gehört jetzt einem anderen Feld oder Fenster</translation>
    </message>
    <message>
        <source>the drive pad is no longer to be seen</source>
        <translation>das Fahrfeld ist nicht mehr zu sehen</translation>
    </message>
    <message>
        <source>a dialog opened over the window</source>
        <translation>ein Dialog liegt über dem Fenster</translation>
    </message>
    <message>
        <source>another AGV was chosen</source>
        <translation>ein anderes AGV wurde gewählt</translation>
    </message>
    <message>
        <source>the keys cancelled each other</source>
        <translation>die Tasten hoben einander auf</translation>
    </message>
    <message>
        <source>the window did not react for a moment</source>
        <translation>das Fenster hat einen Moment nicht reagiert</translation>
    </message>
    <message>
        <source>the screen was locked</source>
        <translation>der Bildschirm wurde gesperrt</translation>
    </message>
    <message>
        <source>this computer or this program was put to sleep</source>
        <translation>dieser Rechner oder dieses Programm wurde schlafen gelegt</translation>
    </message>
    <message>
        <source>no word came from the operator&apos;s hand for 250 ms</source>
        <translation>250 ms lang kam keine Meldung von der Hand des Bedieners</translation>
    </message>
    <message>
        <source>the robot did not confirm a command for 250 ms: check its Wi-Fi</source>
        <translation>der Roboter hat 250 ms lang keinen Befehl bestätigt: sein WLAN prüfen</translation>
    </message>
    <message>
        <source>the link to the robot was lost</source>
        <translation>die Verbindung zum Roboter ging verloren</translation>
    </message>
    <message>
        <source>the robot docks or undocks by itself: wait, or press Stop</source>
        <translation>der Roboter dockt gerade selbst an oder ab: warten oder „Anhalten“ drücken</translation>
    </message>
    <message>
        <source>Stop all was pressed: look that the way is free, then release it</source>
        <translation>„Alle anhalten“ wurde gedrückt: prüfen, ob der Weg frei ist, dann freigeben</translation>
    </message>
    <message>
        <source>it is driven from elsewhere: mouse and keys do not drive together</source>
        <translation>es wird schon gefahren: Maus und Tasten fahren nicht zusammen</translation>
    </message>
    <message>
        <source>it is driven by hand: let go first</source>
        <translation>es wird von Hand gefahren: zuerst loslassen</translation>
    </message>
    <message>
        <source>the speed is zero</source>
        <translation>die Geschwindigkeit ist null</translation>
    </message>
</context>
<context>
    <name>agv::model::PlotFeed</name>
    <message>
        <source>Position</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>Heading</source>
        <translation>Richtung</translation>
    </message>
    <message>
        <source>Position error</source>
        <translation>Positionsfehler</translation>
    </message>
    <message>
        <source>Heading error</source>
        <translation>Richtungsfehler</translation>
    </message>
    <message>
        <source>Position uncertainty, 95 %</source>
        <translation>Unsicherheit der Position, 95 %</translation>
    </message>
    <message>
        <source>UWB ranges</source>
        <translation>UWB-Abstände</translation>
    </message>
    <message>
        <source>UWB residuals</source>
        <translation>UWB-Abweichungen</translation>
    </message>
    <message>
        <source>RSSI of floor tags</source>
        <translation>RSSI der Bodentags</translation>
    </message>
    <message>
        <source>Wheel speeds</source>
        <translation>Radgeschwindigkeiten</translation>
    </message>
    <message>
        <source>Battery charge</source>
        <translation>Ladung der Batterie</translation>
    </message>
    <message>
        <source>Battery voltage</source>
        <translation>Spannung der Batterie</translation>
    </message>
    <message>
        <source>Message rates</source>
        <translation>Meldungsraten</translation>
    </message>
    <message>
        <source>Age of the last message</source>
        <translation>Alter der letzten Meldung</translation>
    </message>
    <message>
        <source>steps</source>
        <translation>Stufen</translation>
    </message>
    <message>
        <source>Tag %1, anchor %2</source>
        <translation>Tag %1, Anker %2</translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>AGV %1 left</source>
        <translation>AGV %1 links</translation>
    </message>
    <message>
        <source>AGV %1 right</source>
        <translation>AGV %1 rechts</translation>
    </message>
    <message>
        <source>AGV %1 RFID</source>
        <translation>AGV %1 RFID</translation>
    </message>
    <message>
        <source>AGV %1 robot</source>
        <translation>AGV %1 Roboter</translation>
    </message>
</context>
<context>
    <name>agv::model::RangeCalibrationModel</name>
    <message>
        <source>Anchor %1</source>
        <translation>Anker %1</translation>
    </message>
    <message>
        <source>Too few ranges: its correction stays as it is</source>
        <translation>Zu wenige Abstände: Seine Korrektur bleibt, wie sie ist</translation>
    </message>
    <message>
        <source>Standard deviation of a single range</source>
        <translation>Standardabweichung eines einzelnen Abstands</translation>
    </message>
    <message>
        <source>Anchor</source>
        <translation>Anker</translation>
    </message>
    <message>
        <source>Ranges</source>
        <translation>Abstände</translation>
    </message>
    <message>
        <source>Found (cm)</source>
        <translation>Gefunden (cm)</translation>
    </message>
    <message>
        <source>Spread (mm)</source>
        <translation>Streuung (mm)</translation>
    </message>
    <message>
        <source>Now (cm)</source>
        <translation>Bisher (cm)</translation>
    </message>
</context>
<context>
    <name>agv::model::ShiftChecks</name>
    <message>
        <source>Plant file</source>
        <translation>Anlagendatei</translation>
    </message>
    <message>
        <source>It holds no floor tags</source>
        <translation>Sie enthält keine Bodentags</translation>
    </message>
    <message>
        <source>Add them to the plant file and start again.</source>
        <translation>Tragen Sie sie in die Anlagendatei ein und starten Sie neu.</translation>
    </message>
    <message>
        <source>It names no AGV</source>
        <translation>Sie nennt kein AGV</translation>
    </message>
    <message>
        <source>Add one to the plant file and start again.</source>
        <translation>Tragen Sie eines in die Anlagendatei ein und starten Sie neu.</translation>
    </message>
    <message>
        <source>%1: %2 floor tags, %3 AGVs</source>
        <translation>%1: %2 Bodentags, %3 AGVs</translation>
    </message>
    <message>
        <source>Port for robots</source>
        <translation>Port für Roboter</translation>
    </message>
    <message>
        <source>End the other program that uses the port, or change the port in the plant file.</source>
        <translation>Beenden Sie das andere Programm, das den Port benutzt, oder ändern Sie den Port in der Anlagendatei.</translation>
    </message>
    <message>
        <source>AGV %1: robot</source>
        <translation>AGV %1: Roboter</translation>
    </message>
    <message>
        <source>Switch the AGV on; it connects by itself.</source>
        <translation>Schalten Sie das AGV ein; es verbindet sich von selbst.</translation>
    </message>
    <message>
        <source>It reports an error</source>
        <translation>Er meldet einen Fehler</translation>
    </message>
    <message>
        <source>Look at its display; switch it off and on again.</source>
        <translation>Sehen Sie auf seine Anzeige; schalten Sie es aus und wieder ein.</translation>
    </message>
    <message>
        <source>AGV %1: battery</source>
        <translation>AGV %1: Batterie</translation>
    </message>
    <message>
        <source>It has not reported its charge</source>
        <translation>Ihre Ladung wurde noch nicht gemeldet</translation>
    </message>
    <message>
        <source>Wait until the robot is connected.</source>
        <translation>Warten Sie, bis der Roboter verbunden ist.</translation>
    </message>
    <message>
        <source>%1, %2</source>
        <translation>%1, %2</translation>
    </message>
    <message>
        <source>Charge it; a shift takes %1 or more.</source>
        <translation>Laden Sie sie; eine Schicht braucht %1 oder mehr.</translation>
    </message>
    <message>
        <source>AGV %1: RFID reader</source>
        <translation>AGV %1: RFID-Leser</translation>
    </message>
    <message>
        <source>It is closed</source>
        <translation>Er ist geschlossen</translation>
    </message>
    <message>
        <source>Press Open RFID.</source>
        <translation>Drücken Sie „RFID öffnen“.</translation>
    </message>
    <message>
        <source>Push the AGV a little, so that its antenna is over a floor tag.</source>
        <translation>Schieben Sie das AGV ein wenig, sodass seine Antenne über einem Bodentag ist.</translation>
    </message>
    <message>
        <source>Has the WeMos bridge power and Wi-Fi? It is tried again by itself.</source>
        <translation>Hat die WeMos-Brücke Strom und WLAN? Es wird von selbst wieder versucht.</translation>
    </message>
    <message>
        <source>Nothing was read for %1</source>
        <translation>Seit %1 wurde nichts gelesen</translation>
    </message>
    <message>
        <source>%1 reads</source>
        <translation>%1 Lesungen</translation>
    </message>
    <message>
        <source>AGV %1: floor tags</source>
        <translation>AGV %1: Bodentags</translation>
    </message>
    <message>
        <source>It reads none</source>
        <translation>Es liest keine</translation>
    </message>
    <message>
        <source>It reads tag %1, which the plant file does not name</source>
        <translation>Es liest den Tag %1, den die Anlagendatei nicht nennt</translation>
    </message>
    <message>
        <source>Is this the plant file of this plant? Else add the tag to it.</source>
        <translation>Ist das die Anlagendatei dieser Anlage? Sonst tragen Sie den Tag ein.</translation>
    </message>
    <message>
        <source>What it reads is in the plant file</source>
        <translation>Was es liest, steht in der Anlagendatei</translation>
    </message>
    <message>
        <source>AGV %1: sleeptime</source>
        <translation>AGV %1: Sleeptime</translation>
    </message>
    <message>
        <source>%1 for wheels at %2</source>
        <translation>%1 für Räder mit %2</translation>
    </message>
    <message>
        <source>For its track about %1 is expected: correct the sleeptime, then calibrate.</source>
        <translation>Für seine Spurweite werden etwa %1 erwartet: Berichtigen Sie die Sleeptime, dann kalibrieren Sie.</translation>
    </message>
    <message>
        <source>UWB unit</source>
        <translation>UWB-Einheit</translation>
    </message>
    <message>
        <source>There is none</source>
        <translation>Es gibt keine</translation>
    </message>
    <message>
        <source>Plug the unit in and choose its serial port in the menu UWB.</source>
        <translation>Stecken Sie die Einheit ein und wählen Sie im Menü UWB ihren seriellen Port.</translation>
    </message>
    <message>
        <source>UWB anchors</source>
        <translation>UWB-Anker</translation>
    </message>
    <message>
        <source>Not heard: %1</source>
        <translation>Nicht gehört: %1</translation>
    </message>
    <message>
        <source>Have they power, and is a tag switched on?</source>
        <translation>Haben sie Strom, und ist ein Tag eingeschaltet?</translation>
    </message>
    <message>
        <source>Not where the list says: %1</source>
        <translation>Nicht, wo die Liste sagt: %1</translation>
    </message>
    <message>
        <source>Put them back, or enter their new places in the list of anchors.</source>
        <translation>Stellen Sie sie zurück oder tragen Sie ihre neuen Orte in die Liste der Anker ein.</translation>
    </message>
    <message>
        <source>All %1 are heard</source>
        <translation>Alle %1 werden gehört</translation>
    </message>
    <message>
        <source>Disk</source>
        <translation>Platte</translation>
    </message>
    <message>
        <source>%1 free</source>
        <translation>%1 frei</translation>
    </message>
    <message>
        <source>Make room: %1 or more.</source>
        <translation>Schaffen Sie Platz: %1 oder mehr.</translation>
    </message>
</context>
<context>
    <name>agv::model::StatisticsTableModel</name>
    <message>
        <source>Of the magnitudes: of a position error the circular errors CE50, CE75, CE95</source>
        <translation>Der Beträge: eines Positionsfehlers die Kreisfehler CE50, CE75, CE95</translation>
    </message>
    <message>
        <source>Of an error: the bias</source>
        <translation>Eines Fehlers: die mittlere Abweichung</translation>
    </message>
    <message>
        <source>Share of the time with a value not older than 1 s</source>
        <translation>Anteil der Zeit mit einem Wert, der nicht älter als 1 s ist</translation>
    </message>
    <message>
        <source>Curve</source>
        <translation>Kurve</translation>
    </message>
    <message>
        <source>At the cursor</source>
        <translation>Am Zeiger</translation>
    </message>
    <message>
        <source>Values</source>
        <translation>Werte</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>Mittel</translation>
    </message>
    <message>
        <source>Std. dev.</source>
        <translation>Std.-Abw.</translation>
    </message>
    <message>
        <source>RMS</source>
        <translation>RMS</translation>
    </message>
    <message>
        <source>Median</source>
        <translation>Median</translation>
    </message>
    <message>
        <source>50 %</source>
        <translation>50 %</translation>
    </message>
    <message>
        <source>75 %</source>
        <translation>75 %</translation>
    </message>
    <message>
        <source>95 %</source>
        <translation>95 %</translation>
    </message>
    <message>
        <source>Largest</source>
        <translation>Größter</translation>
    </message>
    <message>
        <source>Available</source>
        <translation>Verfügbar</translation>
    </message>
</context>
<context>
    <name>agv::model::StopTableModel</name>
    <message>
        <source>Tag %1, RSSI %2</source>
        <translation>Tag %1, RSSI %2</translation>
    </message>
    <message>
        <source>Stop %1: %2 reads of %3 tags</source>
        <translation>Stopp %1: %2 Lesungen von %3 Tags</translation>
    </message>
    <message>
        <source>Expected but not seen: %1</source>
        <translation>Erwartet, aber nicht gesehen: %1</translation>
    </message>
    <message>
        <source>Not in the plant file: %1</source>
        <translation>Nicht in der Anlagendatei: %1</translation>
    </message>
    <message>
        <source>Belongs elsewhere: %1</source>
        <translation>Gehört woandershin: %1</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>Stopp</translation>
    </message>
    <message>
        <source>Reads</source>
        <translation>Lesungen</translation>
    </message>
    <message>
        <source>RSSI %1</source>
        <translation>RSSI %1</translation>
    </message>
    <message>
        <source>Tag %1</source>
        <translation>Tag %1</translation>
    </message>
</context>
<context>
    <name>agv::model::UwbTagTableModel</name>
    <message>
        <source>UWB tag %1</source>
        <translation>UWB-Tag %1</translation>
    </message>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>Not heard</source>
        <translation>Nicht zu hören</translation>
    </message>
    <message>
        <source>Fix</source>
        <translation>Position</translation>
    </message>
    <message>
        <source>not listed</source>
        <translation>nicht eingetragen</translation>
    </message>
    <message>
        <source>No range to %1 in the last report</source>
        <translation>Kein Abstand von %1 im letzten Bericht</translation>
    </message>
    <message>
        <source>Not used: the range to %1 does not fit the others, its view is probably blocked</source>
        <translation>Nicht verwendet: Der Abstand von %1 passt nicht zu den anderen, die Sicht ist wahrscheinlich verdeckt</translation>
    </message>
    <message>
        <source>Measured minus expected: %1</source>
        <translation>Gemessen minus erwartet: %1</translation>
    </message>
    <message>
        <source>Range to %1, corrected</source>
        <translation>Abstand von %1, korrigiert</translation>
    </message>
    <message>
        <source>No report of this tag yet: switch it on and open the UWB unit</source>
        <translation>Noch kein Bericht dieses Tags: einschalten und die UWB-Einheit öffnen</translation>
    </message>
    <message>
        <source>This tag is heard but is not in the list: an entry of a label, an AGV or a height lists it</source>
        <translation>Dieses Tag ist zu hören, steht aber nicht in der Liste: Ein Name, ein AGV oder eine Höhe trägt es ein</translation>
    </message>
    <message>
        <source>Too few positions yet</source>
        <translation>Noch zu wenige Positionen</translation>
    </message>
    <message>
        <source>%1 reports, %2 exchanges missed</source>
        <translation>%1 Berichte, %2 Messungen verpasst</translation>
    </message>
    <message>
        <source>There is no AGV &quot;%1&quot;: choose one of the plant for %2, or none.</source>
        <translation>Es gibt kein AGV „%1“: Wählen Sie für %2 eines der Anlage oder keines.</translation>
    </message>
    <message>
        <source>the height of %1 in mm</source>
        <translation>die Höhe von %1 in mm</translation>
    </message>
    <message>
        <source>the number of %1</source>
        <translation>die Nummer von %1</translation>
    </message>
    <message>
        <source>There is a UWB tag %1 already (%2): choose another number.</source>
        <translation>Es gibt schon ein UWB-Tag %1 (%2): Wählen Sie eine andere Nummer.</translation>
    </message>
    <message>
        <source>Edit %1</source>
        <translation>%1 ändern</translation>
    </message>
    <message>
        <source>List %1</source>
        <translation>%1 eintragen</translation>
    </message>
    <message>
        <source>No.</source>
        <comment>number of a UWB tag</comment>
        <translation>Nr.</translation>
    </message>
    <message>
        <source>Number of the tag, as in the reports: 0 to 255</source>
        <translation>Nummer des Tags, wie in den Berichten: 0 bis 255</translation>
    </message>
    <message>
        <source>Tag</source>
        <translation>Tag</translation>
    </message>
    <message>
        <source>Name on the map and in messages</source>
        <translation>Name auf der Karte und in Meldungen</translation>
    </message>
    <message>
        <source>AGV</source>
        <translation>AGV</translation>
    </message>
    <message>
        <source>The AGV that carries the tag</source>
        <translation>Das AGV, das das Tag trägt</translation>
    </message>
    <message>
        <source>z (mm)</source>
        <translation>z (mm)</translation>
    </message>
    <message>
        <source>Height of the tag&apos;s antenna above the floor</source>
        <translation>Höhe der Antenne des Tags über dem Boden</translation>
    </message>
    <message>
        <source>x (mm)</source>
        <translation>x (mm)</translation>
    </message>
    <message>
        <source>Position of the tag&apos;s antenna, to the east of the plant&apos;s origin</source>
        <translation>Position der Antenne des Tags, östlich vom Ursprung der Anlage</translation>
    </message>
    <message>
        <source>y (mm)</source>
        <translation>y (mm)</translation>
    </message>
    <message>
        <source>Position of the tag&apos;s antenna, to the north of the plant&apos;s origin</source>
        <translation>Position der Antenne des Tags, nördlich vom Ursprung der Anlage</translation>
    </message>
    <message>
        <source>95 % (mm)</source>
        <translation>95 % (mm)</translation>
    </message>
    <message>
        <source>The position lies within this of x and y with 95 % certainty, for anchors that stand where the list says</source>
        <translation>Die Position liegt mit 95 % Sicherheit so nahe an x und y, wenn die Anker stehen, wo die Liste sagt</translation>
    </message>
    <message>
        <source>Age</source>
        <translation>Alter</translation>
    </message>
    <message>
        <source>Time since the ranges were measured</source>
        <translation>Zeit, seit die Abstände gemessen wurden</translation>
    </message>
    <message>
        <source>Reports per second</source>
        <translation>Berichte je Sekunde</translation>
    </message>
    <message>
        <source>R95 (mm)</source>
        <translation>R95 (mm)</translation>
    </message>
    <message>
        <source>Repeatability: 95 % of the last positions lie within this of their own mean. It says nothing of how far that mean is from the truth</source>
        <translation>Wiederholgenauigkeit: 95 % der letzten Positionen liegen so nahe an ihrem eigenen Mittel. Wie weit das Mittel von der Wahrheit liegt, sagt sie nicht</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>Fix: there is a position; else the reason why there is none</source>
        <translation>Position: Es gibt eine; sonst der Grund, warum nicht</translation>
    </message>
    <message>
        <source>%1 (mm)</source>
        <comment>range to this anchor</comment>
        <translation>%1 (mm)</translation>
    </message>
    <message>
        <source>Last range to %1, corrected. A cross marks a range that is not used</source>
        <translation>Letzter Abstand von %1, korrigiert. Ein Kreuz markiert einen Abstand, der nicht verwendet wird</translation>
    </message>
    <message>
        <source>Rate (1/s)</source>
        <translation>Rate (1/s)</translation>
    </message>
</context>
<context>
    <name>agv::model::VehicleTableModel</name>
    <message>
        <source>AGV %1</source>
        <translation>AGV %1</translation>
    </message>
    <message>
        <source>May be moving</source>
        <translation>Fährt vielleicht</translation>
    </message>
    <message>
        <source>The connection was lost while the wheels were turning. Go and look before you drive.</source>
        <translation>Die Verbindung brach ab, während sich die Räder drehten. Sehen Sie nach, bevor Sie fahren.</translation>
    </message>
    <message>
        <source>Battery: %1, %2</source>
        <translation>Batterie: %1, %2</translation>
    </message>
    <message>
        <source>Temperature: %1 °C</source>
        <translation>Temperatur: %1 °C</translation>
    </message>
    <message>
        <source>The robot has not connected. Switch it on; it connects by itself.</source>
        <translation>Der Roboter hat sich nicht verbunden. Schalten Sie ihn ein; er verbindet sich selbst.</translation>
    </message>
    <message>
        <source>AGV</source>
        <translation>AGV</translation>
    </message>
    <message>
        <source>Battery</source>
        <translation>Batterie</translation>
    </message>
    <message>
        <source>Charge</source>
        <translation>Ladung</translation>
    </message>
    <message>
        <source>State</source>
        <translation>Zustand</translation>
    </message>
    <message>
        <source>The robot is connected but has not reported its battery yet.</source>
        <translation>Der Roboter ist verbunden, hat seine Batterie aber noch nicht gemeldet.</translation>
    </message>
</context>
<context>
    <name>agv::model::Words</name>
    <message>
        <source>mm</source>
        <translation>mm</translation>
    </message>
    <message>
        <source>Closed</source>
        <translation>Geschlossen</translation>
    </message>
    <message>
        <source>Opening</source>
        <translation>Öffnet</translation>
    </message>
    <message>
        <source>Up</source>
        <translation>Verbunden</translation>
    </message>
    <message>
        <source>Silent</source>
        <translation>Stumm</translation>
    </message>
    <message>
        <source>Waiting</source>
        <translation>Wartet</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>Gescheitert</translation>
    </message>
    <message>
        <source>Idle</source>
        <translation>Bereit</translation>
    </message>
    <message>
        <source>Driving a segment</source>
        <translation>Fährt Segment</translation>
    </message>
    <message>
        <source>Waiting for a segment</source>
        <translation>Wartet auf Segment</translation>
    </message>
    <message>
        <source>Driving directly</source>
        <translation>Fährt direkt</translation>
    </message>
    <message>
        <source>Docking</source>
        <translation>Dockt an</translation>
    </message>
    <message>
        <source>Docked</source>
        <translation>Angedockt</translation>
    </message>
    <message>
        <source>Undocking</source>
        <translation>Dockt ab</translation>
    </message>
    <message>
        <source>Docking (demo)</source>
        <translation>Dockt an (Demo)</translation>
    </message>
    <message>
        <source>Error</source>
        <translation>Fehler</translation>
    </message>
    <message>
        <source>not charging</source>
        <translation>lädt nicht</translation>
    </message>
    <message>
        <source>reconditioning</source>
        <translation>wird aufgefrischt</translation>
    </message>
    <message>
        <source>charging</source>
        <translation>lädt</translation>
    </message>
    <message>
        <source>trickle charging</source>
        <translation>Erhaltungsladung</translation>
    </message>
    <message>
        <source>waiting to charge</source>
        <translation>wartet auf Ladung</translation>
    </message>
    <message>
        <source>charging fault</source>
        <translation>Ladefehler</translation>
    </message>
    <message>
        <source>Info</source>
        <translation>Info</translation>
    </message>
    <message>
        <source>Warning</source>
        <translation>Warnung</translation>
    </message>
    <message>
        <source>No turn yet</source>
        <translation>Noch keine Drehung</translation>
    </message>
    <message>
        <source>coming to rest</source>
        <translation>kommt zur Ruhe</translation>
    </message>
    <message>
        <source>reading tags</source>
        <translation>liest Tags</translation>
    </message>
    <message>
        <source>turning</source>
        <translation>dreht</translation>
    </message>
    <message>
        <source>Computing the position</source>
        <translation>Berechnet die Position</translation>
    </message>
    <message>
        <source>Finished</source>
        <translation>Fertig</translation>
    </message>
    <message>
        <source>Aborted</source>
        <translation>Abgebrochen</translation>
    </message>
    <message>
        <source>ms</source>
        <translation>ms</translation>
    </message>
    <message>
        <source>s</source>
        <translation>s</translation>
    </message>
    <message>
        <source>min</source>
        <translation>min</translation>
    </message>
    <message>
        <source>/s</source>
        <comment>per second</comment>
        <translation>/s</translation>
    </message>
    <message>
        <source>V</source>
        <translation>V</translation>
    </message>
    <message>
        <source>Detail</source>
        <translation>Detail</translation>
    </message>
    <message>
        <source>Not connected</source>
        <translation>Nicht verbunden</translation>
    </message>
    <message>
        <source>State unknown</source>
        <translation>Zustand unbekannt</translation>
    </message>
    <message>
        <source>mm/s</source>
        <translation>mm/s</translation>
    </message>
</context>
</TS>
