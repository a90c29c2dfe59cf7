// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/uwb_screens.h"

#include "gui/hint_table_view.h"
#include "gui/main_window.h"
#include "gui/uwb_table_panel.h"
#include "model/messages.h"
#include "ui_main_window.h"

#include <QHeaderView>

#include <algorithm>

namespace agv::gui {

using model::AnchorTableModel;
using model::UwbTagTableModel;

UwbScreens::UwbScreens(Ui::MainWindow& ui, MainWindow* window) : m_ui(ui), m_window(window)
{
    buildPanels();
    connectModels();
    connectActions();
    connectUndo();
}

// The undo list reports its own end; the panels have no use for that.
UwbScreens::~UwbScreens() { m_editor.undoStack().blockSignals(true); }

void UwbScreens::buildPanels()
{
    HintTableView* anchors = m_ui.anchors->table();
    anchors->setObjectName(QStringLiteral("anchorTable"));
    anchors->setModel(&m_anchors);
    m_ui.anchors->useDelegate(AnchorTableModel::WarningRole, -1);
    anchors->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    anchors->horizontalHeader()->setStretchLastSection(true);
    m_ui.anchors->setActions({m_ui.addAnchorAction, m_ui.removeAnchorAction, m_ui.undoUwbAction,
                              m_ui.redoUwbAction, m_ui.saveUwbAction, m_ui.placeAnchorsAction,
                              m_ui.correctionsAction, m_ui.importUwbAction, m_ui.exportUwbAction});

    HintTableView* tags = m_ui.uwbTags->table();
    tags->setObjectName(QStringLiteral("uwbTagTable"));
    tags->setModel(&m_tags);
    m_ui.uwbTags->useDelegate(UwbTagTableModel::WarningRole, UwbTagTableModel::ChoicesRole);
    tags->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    tags->horizontalHeader()->setMaximumSectionSize(24 * tags->fontMetrics().averageCharWidth());
    m_ui.uwbTags->setActions({m_ui.addTagAction, m_ui.removeTagAction, m_ui.undoUwbAction, m_ui.redoUwbAction,
                              m_ui.saveUwbAction, m_ui.calibrateRangesAction, m_ui.correctionsAction,
                              m_ui.uwbPortAction});
    for (const HintTableView* table : {anchors, tags}) {
        connect(table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
                &UwbScreens::updateActions);
        connect(table->model(), &QAbstractItemModel::modelReset, this, &UwbScreens::updateActions);
        connect(table->model(), &QAbstractItemModel::rowsRemoved, this, &UwbScreens::updateActions);
    }
}

void UwbScreens::connectModels()
{
    connect(&m_anchors, &AnchorTableModel::editRequested, &m_editor, &UwbEditor::setAnchors);
    connect(&m_tags, &UwbTagTableModel::editRequested, &m_editor, &UwbEditor::setTags);
    connect(m_ui.map, &MapWidget::anchorMoved, this, &UwbScreens::moveAnchor);
    connect(&m_anchors, &AnchorTableModel::refused, this,
            [this](const QString& sentence) { m_ui.anchors->setNote(sentence, true); });
    connect(&m_tags, &UwbTagTableModel::refused, this,
            [this](const QString& sentence) { m_ui.uwbTags->setNote(sentence, true); });
    connect(&m_editor, &UwbEditor::edited, this, &UwbScreens::onEdited);
    connect(&m_editor, &UwbEditor::edited, m_window, &MainWindow::uwbEdited);
    connect(&m_editor, &UwbEditor::unsavedChanged, this, [this](bool unsaved) {
        m_window->setWindowModified(unsaved && m_isSavable);
        showState();
    });
}

void UwbScreens::moveAnchor(int id, Point2 place)
{
    std::vector<UwbAnchor> anchors = m_editor.anchors();
    const auto moved = std::ranges::find(anchors, id, &UwbAnchor::id);
    if (moved == anchors.end())
        return;
    moved->x = place.x;
    moved->y = place.y;
    m_editor.setAnchors(tr("Move %1").arg(model::anchorName(*moved)), anchors);
}

void UwbScreens::connectActions()
{
    connect(m_ui.addAnchorAction, &QAction::triggered, this, [this] {
        if (!m_editor.addAnchor())
            return m_ui.anchors->setNote(tr("All 256 anchor numbers are in use."), true);
        m_ui.anchors->table()->selectRow(m_anchors.rowCount() - 1);
    });
    connect(m_ui.addTagAction, &QAction::triggered, this, [this] {
        if (!m_editor.addTag())
            return m_ui.uwbTags->setNote(tr("All 256 tag numbers are in use."), true);
        m_ui.uwbTags->table()->selectRow(static_cast<int>(m_editor.settings().tags.size()) - 1);
    });
    connect(m_ui.removeAnchorAction, &QAction::triggered, this, &UwbScreens::removeChosenAnchors);
    connect(m_ui.removeTagAction, &QAction::triggered, this, &UwbScreens::removeChosenTags);
    connect(m_ui.importUwbAction, &QAction::triggered, this, &UwbScreens::importFile);
    connect(m_ui.exportUwbAction, &QAction::triggered, this, &UwbScreens::exportFile);
    connect(m_ui.saveUwbAction, &QAction::triggered, this, &UwbScreens::save);
    connect(m_ui.correctionsAction, &QAction::triggered, this, &UwbScreens::openCorrections);
    connect(m_ui.calibrateRangesAction, &QAction::triggered, this, &UwbScreens::openCalibration);
    connect(m_ui.placeAnchorsAction, &QAction::triggered, this, &UwbScreens::openSurvey);
    connect(m_ui.uwbPortAction, &QAction::triggered, this, &UwbScreens::openPorts);
    connect(m_ui.links, &LinksPanel::uwbPortRequested, this, &UwbScreens::openPorts);
}

void UwbScreens::connectUndo()
{
    QUndoStack& stack = m_editor.undoStack();
    connect(&stack, &QUndoStack::indexChanged, this, &UwbScreens::updateUndo);
    connect(m_ui.undoUwbAction, &QAction::triggered, &stack, &QUndoStack::undo);
    connect(m_ui.redoUwbAction, &QAction::triggered, &stack, &QUndoStack::redo);
    updateUndo();
}

void UwbScreens::updateUndo()
{
    const QUndoStack& stack = m_editor.undoStack();
    m_ui.undoUwbAction->setEnabled(stack.canUndo());
    m_ui.redoUwbAction->setEnabled(stack.canRedo());
    m_ui.undoUwbAction->setToolTip(stack.canUndo() ? tr("Undo: %1").arg(stack.undoText())
                                                   : tr("There is nothing to undo"));
    m_ui.redoUwbAction->setToolTip(stack.canRedo() ? tr("Redo: %1").arg(stack.redoText())
                                                   : tr("There is nothing to redo"));
}

void UwbScreens::setPlant(const PlantLayout& plant)
{
    m_plant = plant;
    m_tags.setAgvs(plant.agvs);
    m_editor.setKit({plant.anchors, plant.uwb});
    onEdited();
}

void UwbScreens::onEdited()
{
    m_plant.anchors = m_editor.anchors();
    m_plant.uwb = m_editor.settings();
    m_anchors.setAnchors(m_editor.anchors());
    m_tags.setSettings(m_editor.anchors(), m_editor.settings());
    m_ui.map->setUwbAnchors(m_editor.anchors());
    showState();
    updateHints();
    updateActions();
}

void UwbScreens::setTheme(const Theme& theme)
{
    m_theme = theme;
    m_ui.anchors->setTheme(theme);
    m_ui.uwbTags->setTheme(theme);
    updateDialogThemes();
}

void UwbScreens::showSnapshot(const PlantSnapshot& snapshot)
{
    m_snapshot = snapshot;
    const UwbSnapshot* uwb = snapshot.uwb ? &*snapshot.uwb : nullptr;
    m_anchors.setSnapshot(uwb);
    m_tags.setSnapshot(uwb);
    updateDialogs();
    updateHints();
}

void UwbScreens::retranslate()
{
    m_ui.anchors->table()->setAccessibleName(tr("UWB anchors"));
    m_ui.uwbTags->table()->setAccessibleName(tr("UWB tags"));
    updateHints();
    updateUndo();
    showState();
    for (HintTableView* table : {m_ui.anchors->table(), m_ui.uwbTags->table()})
        table->horizontalHeader()->viewport()->update();
}

void UwbScreens::setSavable(bool savable)
{
    m_isSavable = savable;
    showState();
}

void UwbScreens::updateHints()
{
    m_ui.anchors->table()->setHint(tr(
        "No UWB anchors, so UWB is not used. Add them here, or import a list of this or another program."));
    const bool open = m_snapshot.uwb && isConnected(m_snapshot.uwb->link);
    m_ui.uwbTags->table()->setHint(
        m_editor.anchors().empty() ? tr("No UWB tags. Add the anchors first (panel UWB anchors), then tags; "
                                        "those that are heard come by "
                                        "themselves.")
        : open ? tr("No UWB tags: none is listed, and none is heard. Switch a tag on, or add one here.")
               : tr("No UWB tags: none is listed. Open the UWB unit in the panel Links and switch a tag on; "
                    "it comes "
                    "by itself. Or add one here."));
}

void UwbScreens::updateActions()
{
    m_ui.removeAnchorAction->setEnabled(!m_ui.anchors->chosenRows().empty());
    bool listed = false;
    for (int row : m_ui.uwbTags->chosenRows())
        listed = listed || m_tags.index(row, 0).data(UwbTagTableModel::ListedRole).toBool();
    m_ui.removeTagAction->setEnabled(listed);
    m_ui.saveUwbAction->setEnabled(m_isSavable && m_editor.hasUnsavedEdits() && !m_saving);
}

void UwbScreens::setPanelNotes(const QString& text, bool isWarning)
{
    m_ui.anchors->setNote(text, isWarning);
    m_ui.uwbTags->setNote(text, isWarning);
}

void UwbScreens::showState()
{
    updateActions();
    if (!m_editor.hasUnsavedEdits())
        return setPanelNotes({}, false);
    setPanelNotes(
        m_isSavable ? tr("In use, but not saved: lost when the console ends.")
                    : tr("In use until the console ends: this plant has no file. Export keeps the anchors."),
        false);
}

void UwbScreens::removeChosenAnchors()
{
    std::vector<int> ids;
    for (int row : m_ui.anchors->chosenRows())
        ids.push_back(m_anchors.anchors()[static_cast<std::size_t>(row)].id);
    m_editor.removeAnchors(ids);
}

void UwbScreens::removeChosenTags()
{
    std::vector<int> ids;
    for (int row : m_ui.uwbTags->chosenRows())
        ids.push_back(m_tags.tag(row).id);
    m_editor.removeTags(ids);
}

} // namespace agv::gui
