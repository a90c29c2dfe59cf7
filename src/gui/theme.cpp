// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/theme.h"

#include <QList>
#include <QPair>

namespace agv::gui {

Theme Theme::light()
{
    Theme t;
    t.window = QColor(0xe9ecef);
    t.panel = QColor(0xf6f7f9);
    t.raised = QColor(0xffffff);
    t.sunken = QColor(0xeef1f4);
    t.border = QColor(0xd3d8de);
    t.strongBorder = QColor(0xa9b2bc);
    t.text = QColor(0x1c232c);
    t.mutedText = QColor(0x5a6572);
    t.disabledText = QColor(0x98a1ab);
    t.accent = QColor(0x2b6390);
    t.accentText = QColor(0xffffff);
    t.selection = QColor(0xd5e3ef);
    t.stopFill = QColor(0x1c232c);
    t.stopHover = QColor(0x3a4552);
    t.stopText = QColor(0xffffff);
    t.warning = QColor(0x9a5200);
    t.warningFill = QColor(0xfff0d9);
    t.error = QColor(0xb3261e);
    t.errorFill = QColor(0xfde7e5);
    t.simulation = QColor(0x5f4596);
    t.simulationFill = QColor(0xe6def5);
    t.mapOutside = QColor(0xdfe3e7);
    t.mapFloor = QColor(0xfafbfc);
    t.mapGrid = QColor(0xe9ecf0);
    t.mapEdge = QColor(0x7d8894);
    t.floorTag = QColor(0xc3cad2);
    t.floorTagNow = QColor(0x2b6390);
    t.station = QColor(0xe2e7ec);
    t.stationEdge = QColor(0x8d98a4);
    t.obstacle = QColor(0xb9c1c9);
    t.agvBody = QColor(0xcdd5de);
    t.agvEdge = QColor(0x3b4754);
    t.estimate = QColor(0x2b6390);
    t.trail = QColor(0x9dbad1);
    t.alternative = QColor(0x9a5200);
    return t;
}

Theme Theme::darkTheme()
{
    Theme t;
    t.dark = true;
    t.window = QColor(0x14171b);
    t.panel = QColor(0x1b1f24);
    t.raised = QColor(0x262b32);
    t.sunken = QColor(0x16191d);
    t.border = QColor(0x323942);
    t.strongBorder = QColor(0x56606c);
    t.text = QColor(0xe4e8ec);
    t.mutedText = QColor(0x9aa5b1);
    t.disabledText = QColor(0x626c77);
    t.accent = QColor(0x7fb4dc);
    t.accentText = QColor(0x0f1a24);
    t.selection = QColor(0x2b4156);
    t.stopFill = QColor(0xe4e8ec);
    t.stopHover = QColor(0xffffff);
    t.stopText = QColor(0x14171b);
    t.warning = QColor(0xf2b04c);
    t.warningFill = QColor(0x3a2d17);
    t.error = QColor(0xff8a80);
    t.errorFill = QColor(0x41201e);
    t.simulation = QColor(0xc3aef2);
    t.simulationFill = QColor(0x2f2645);
    t.mapOutside = QColor(0x101316);
    t.mapFloor = QColor(0x1c2025);
    t.mapGrid = QColor(0x262b31);
    t.mapEdge = QColor(0x6d7884);
    t.floorTag = QColor(0x465059);
    t.floorTagNow = QColor(0x8fc4ec);
    t.station = QColor(0x2a3037);
    t.stationEdge = QColor(0x66717d);
    t.obstacle = QColor(0x3d454e);
    t.agvBody = QColor(0x46515d);
    t.agvEdge = QColor(0xc3ccd6);
    t.estimate = QColor(0x8fc4ec);
    t.trail = QColor(0x4c6e8a);
    t.alternative = QColor(0xf2b04c);
    return t;
}

Theme Theme::fromPalette(const QPalette& palette)
{
    return palette.color(QPalette::Window).lightness() < 128 ? darkTheme() : light();
}

QPalette Theme::toPalette() const
{
    QPalette p;
    p.setColor(QPalette::Window, window);
    p.setColor(QPalette::WindowText, text);
    p.setColor(QPalette::Base, raised);
    p.setColor(QPalette::AlternateBase, panel);
    p.setColor(QPalette::Text, text);
    p.setColor(QPalette::PlaceholderText, mutedText);
    p.setColor(QPalette::Button, raised);
    p.setColor(QPalette::ButtonText, text);
    p.setColor(QPalette::BrightText, raised);
    p.setColor(QPalette::Light, raised);
    p.setColor(QPalette::Midlight, panel);
    p.setColor(QPalette::Mid, border);
    p.setColor(QPalette::Dark, strongBorder);
    p.setColor(QPalette::Shadow, strongBorder);
    p.setColor(QPalette::Highlight, selection);
    p.setColor(QPalette::HighlightedText, text);
    p.setColor(QPalette::Link, accent);
    p.setColor(QPalette::LinkVisited, accent);
    p.setColor(QPalette::ToolTipBase, raised);
    p.setColor(QPalette::ToolTipText, text);
    for (QPalette::ColorRole role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
        p.setColor(QPalette::Disabled, role, disabledText);
    return p;
}

namespace {

// Tokens of the form @name are replaced by the theme's colours.
const char* const sheetTemplate = R"(
QWidget { color: @text; }
QWidget:disabled { color: @disabledText; }
QMainWindow, QDialog { background: @window; }
QWidget#centralwidget { background: @mapOutside; }
QMenuBar { background: @panel; border-bottom: 1px solid @border; padding: 1px 4px; }
QMenuBar::item { padding: 4px 10px; border-radius: 4px; background: transparent; }
QMenuBar::item:selected { background: @selection; }
QMenu { background: @raised; border: 1px solid @border; padding: 4px; }
QMenu::item { padding: 5px 28px 5px 26px; border-radius: 4px; }
QMenu::item:selected { background: @selection; }
QMenu::item:disabled { color: @disabledText; }
QMenu::separator { height: 1px; background: @border; margin: 4px 8px; }
QToolBar { background: @panel; border: none; border-bottom: 1px solid @border; padding: 5px 8px; spacing: 4px; }
QToolBar#uwbBar { border: none; padding: 2px 0px; spacing: 2px; }
QToolBar#uwbBar QToolButton { padding: 3px 8px; }
QToolBar#uwbBar QToolBarExtension { padding: 0px; border: 1px solid @border; border-radius: 4px; }
QToolBar::separator { width: 1px; background: @border; margin: 4px 6px; }
QToolButton { border: 1px solid transparent; border-radius: 6px; padding: 5px 8px; background: transparent; }
QToolButton:hover { background: @sunken; border-color: @border; }
QToolButton:checked { background: @selection; border-color: @accent; }
QToolButton:focus { border-color: @accent; }
QToolButton#stopAllButton { background: @stopFill; color: @stopText; border: 2px solid @stopFill;
    border-radius: 6px; padding: 7px 20px; font-weight: 700; }
QToolButton#stopAllButton:hover { background: @stopHover; border-color: @stopHover; }
QToolButton#stopAllButton:focus { border-color: @accent; }
QToolButton#stopAllButton:pressed { background: @mutedText; }
QStatusBar { background: @panel; border-top: 1px solid @border; color: @mutedText; }
QStatusBar::item { border: none; }
QStatusBar QLabel { color: @mutedText; padding: 1px 8px; }
QDockWidget { color: @text; font-weight: 600; }
QDockWidget::title { background: @panel; padding: 7px 10px; border-bottom: 1px solid @border; text-align: left; }
QDockWidget > QWidget { background: @panel; }
QMainWindow::separator { background: @window; width: 5px; height: 5px; }
QMainWindow::separator:hover { background: @strongBorder; }
QScrollArea, QScrollArea > QWidget > QWidget { background: transparent; border: none; }
QLabel[role="muted"] { color: @mutedText; }
QLabel#nextStepLabel { background: @panel; border-top: 1px solid @border; padding: 6px 12px; }
QLabel[role="heading"] { font-weight: 600; }
QLabel#simulationBanner { background: @simulationFill; color: @simulation; font-weight: 700;
    padding: 4px; border-bottom: 1px solid @simulation; }
QLabel[role="notice"] { background: @warningFill; color: @text; border: 1px solid @warning;
    border-radius: 6px; padding: 6px 8px; }
QFrame#noticeBar { background: @errorFill; border: none; border-bottom: 1px solid @error; }
QFrame#resultCard { background: @raised; border: 1px solid @border; border-radius: 8px; }
QFrame#resultCard[verdict="warning"] { background: @warningFill; border: 1px solid @warning; }
QFrame#resultCard[verdict="error"] { background: @errorFill; border: 1px solid @error; }
QPushButton { background: @raised; border: 1px solid @strongBorder; border-radius: 6px; padding: 5px 14px; }
QPushButton:hover { background: @sunken; }
QPushButton:checked { background: @selection; border-color: @accent; }
QPushButton:pressed { background: @border; }
QPushButton:focus { border: 2px solid @accent; padding: 4px 13px; }
QPushButton:disabled { color: @disabledText; border-color: @border; background: @panel; }
QPushButton[primary="true"] { background: @accent; color: @accentText; border-color: @accent; font-weight: 600; }
QPushButton[primary="true"]:hover { background: @accentHover; }
QPushButton[primary="true"]:focus { border: 2px solid @text; }
QPushButton[primary="true"]:disabled { background: @border; color: @disabledText; border-color: @border; }
QComboBox, QSpinBox, QDoubleSpinBox, QLineEdit { background: @raised; border: 1px solid @strongBorder;
    border-radius: 5px; padding: 3px 6px; min-height: 1.5em; selection-background-color: @selection;
    selection-color: @text; }
QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus, QLineEdit:focus { border: 2px solid @accent; padding: 2px 5px; }
QComboBox:disabled, QSpinBox:disabled, QLineEdit:disabled { color: @disabledText; border-color: @border; background: @panel; }
QComboBox::drop-down { border: none; width: 20px; }
QComboBox QAbstractItemView { background: @raised; border: 1px solid @border; selection-background-color: @selection;
    selection-color: @text; outline: none; }
QTableView { background: @raised; alternate-background-color: @panel; border: 1px solid @border; border-radius: 6px;
    gridline-color: transparent; outline: none; selection-background-color: @selection; selection-color: @text; }
QTableView:focus { border: 1px solid @accent; }
QTableView::item { padding: 2px 6px; border: none; }
QTableView::item:selected { background: @selection; color: @text; }
QHeaderView { background: @panel; }
QHeaderView::section { background: @panel; color: @mutedText; border: none; border-bottom: 1px solid @border;
    padding: 4px 6px; font-weight: 400; }
QTableCornerButton::section { background: @panel; border: none; border-bottom: 1px solid @border; }
QProgressBar { background: @sunken; border: 1px solid @border; border-radius: 3px; max-height: 6px; min-height: 6px; }
QProgressBar::chunk { background: @accent; border-radius: 2px; }
QTabWidget::pane { border: none; }
QTabBar::tab { background: transparent; color: @mutedText; padding: 6px 12px; border: none;
    border-bottom: 2px solid transparent; }
QTabBar::tab:selected { color: @text; border-bottom-color: @accent; }
QTabBar::tab:hover { color: @text; }
QTabBar::tab:focus { background: @selection; }
QScrollBar:vertical { background: transparent; width: 10px; margin: 0; }
QScrollBar:horizontal { background: transparent; height: 10px; margin: 0; }
QScrollBar::handle { background: @strongBorder; border-radius: 3px; margin: 2px; min-height: 24px; min-width: 24px; }
QScrollBar::handle:hover { background: @mutedText; }
QScrollBar::add-line, QScrollBar::sub-line { width: 0; height: 0; }
QScrollBar::add-page, QScrollBar::sub-page { background: transparent; }
QCheckBox { spacing: 7px; }
QToolTip { background: @raised; color: @text; border: 1px solid @strongBorder; padding: 4px 6px; }
)";

} // namespace

QString Theme::styleSheet() const
{
    const QList<QPair<const char*, QColor>> tokens{
        {"@window", window},
        {"@panel", panel},
        {"@raised", raised},
        {"@sunken", sunken},
        {"@border", border},
        {"@strongBorder", strongBorder},
        {"@text", text},
        {"@mutedText", mutedText},
        {"@disabledText", disabledText},
        // Longest first, so that no token is the beginning of a later one.
        {"@accentHover", dark ? accent.lighter(115) : accent.darker(115)},
        {"@accentText", accentText},
        {"@accent", accent},
        {"@selection", selection},
        {"@stopFill", stopFill},
        {"@stopHover", stopHover},
        {"@stopText", stopText},
        {"@warningFill", warningFill},
        {"@warning", warning},
        {"@errorFill", errorFill},
        {"@error", error},
        {"@simulationFill", simulationFill},
        {"@simulation", simulation},
        {"@mapOutside", mapOutside},
    };
    QString sheet = QString::fromLatin1(sheetTemplate);
    for (const auto& [token, colour] : tokens)
        sheet.replace(QLatin1String(token), colour.name());
    return sheet;
}

} // namespace agv::gui
