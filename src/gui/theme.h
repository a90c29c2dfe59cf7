// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

namespace agv::gui {

/// Every colour of the program. Grey and quiet, after ISA-101: a saturated colour means that something is
/// not as it should be, and never stands without a word or a shape.
struct Theme {
    bool dark = false;

    QColor window, panel, raised, sunken, border, strongBorder;
    QColor text, mutedText, disabledText;
    QColor accent, accentText, selection;          ///< focus, selection, the one primary action
    QColor stopFill, stopHover, stopText;          ///< Stop all: the strongest contrast on the screen
    QColor warning, warningFill, error, errorFill; ///< the abnormal
    QColor simulation, simulationFill;             ///< nothing on this screen is real

    QColor mapOutside, mapFloor, mapGrid, mapEdge;
    QColor floorTag, floorTagNow, station, stationEdge, obstacle;
    QColor agvBody, agvEdge, estimate, alternative, trail;

    /// The light or the dark set, whichever fits the window colour of `palette`.
    static Theme fromPalette(const QPalette& palette);
    static Theme light();
    static Theme darkTheme();

    QPalette toPalette() const;
    /// Style sheet of the main window; sizes follow the font (em), so it scales with it.
    QString styleSheet() const;
};

} // namespace agv::gui
