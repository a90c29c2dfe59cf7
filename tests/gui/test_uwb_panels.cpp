// SPDX-License-Identifier: GPL-3.0-or-later
#include <QSignalSpy>
#include <QTest>

#include "gui/map/map_widget.h"
#include "gui/uwb_fixture.h"
#include "gui/uwb_table_panel.h"
#include "model/anchor_table_model.h"
#include "model/uwb_tag_table_model.h"

#include <QFileDialog>
#include <QLabel>
#include <QMessageBox>
#include <QPushButton>

using namespace agv;
using namespace agv::gui;
using Anchors = model::AnchorTableModel;
using Tags = model::UwbTagTableModel;

/// Lists of anchors and tags, their undo list, their way to the application and back.
class UwbPanelTest : public UwbFixture {
    Q_OBJECT
private slots:
    void emptyTablesSayWhyAndHowToFillThem();
    void anEditHoldsAtOnceAndIsUndoneAndRedone();
    void addingAndRemovingAnAnchorIsUndone();
    void aRemovedAnchorTakesItsCorrectionsAlongAndUndoBringsThemBack();
    void aRenumberedAnchorKeepsItsCorrections();
    void everyEditIsAnEntryOfItsOwn();
    void tagsAreAddedEditedAndRemovedWithUndo();
    void aTagThatIsOnlyHeardCannotBeRemoved();
    void refusedInputLeavesASentenceAndTheListAsItWas();
    void theMapShowsAnAnchorWhereItWasMovedTo();
    void anImportIsOneEditAndShowsItsNotes();
    void anExportAndASaveCarryWhatIsShown();
    void aFailedSaveKeepsTheEditsUnsavedAndSaysWhy();
    void anEditDuringASaveStaysUnsaved();
    void closingWithUnsavedEditsAsks();
    void closingCanSaveFirst();
    void withoutAPlantFileNothingIsSavedOrAskedAndTheNoteSaysSo();
    void aFailedSaveKeepsTheWindowOpen();
    void filesAreChosenInADialog();
    void thePanelsAreInTheViewMenuAndTheSavedLayout();
    void everyEditIsAlsoInTheMenu();
    void theWindowFitsASmallScreenInGermanWithThePanelsInSight();
    void theLanguageChangesWhileThePanelsAreOpen();

private:
    QString note(const char* dock) const
    {
        for (const QLabel* label : find<QDockWidget>(dock)->widget()->findChildren<QLabel*>()) {
            if (!label->text().isEmpty() && label->isVisibleTo(find<QDockWidget>(dock)))
                return label->text();
        }
        return {};
    }
};

void UwbPanelTest::emptyTablesSayWhyAndHowToFillThem()
{
    const auto* anchors = find<HintTableView>("anchorTable");
    const auto* tags = find<HintTableView>("uwbTagTable");
    QVERIFY(anchors->showsHint() && anchors->hint().contains(QStringLiteral("import")));
    QVERIFY(tags->showsHint() && tags->hint().contains(QStringLiteral("Add the anchors first")));
    PlantLayout plant = scenes::uwbPlant();
    plant.uwb.tags.clear();
    plant.uwb.corrections.clear();
    open(plant);
    PlantSnapshot snapshot = scenes::uwbRunning();
    snapshot.uwb->tags.clear();
    snapshot.uwb->link.state = LinkState::Down;
    m_window->showSnapshot(snapshot);
    tags = find<HintTableView>("uwbTagTable");
    QVERIFY2(tags->hint().contains(QStringLiteral("Open the UWB unit")), qPrintable(tags->hint()));
    snapshot.uwb->link.state = LinkState::Silent;
    m_window->showSnapshot(snapshot);
    QVERIFY2(tags->hint().contains(QStringLiteral("Switch a tag on")), qPrintable(tags->hint()));
}

void UwbPanelTest::anEditHoldsAtOnceAndIsUndoneAndRedone()
{
    openRunning();
    const PlantLayout plant = scenes::uwbPlant();
    QVERIFY(!find<QAction>("undoUwbAction")->isEnabled());
    QVERIFY(!m_window->isWindowModified());
    QVERIFY(enter("anchorTable", 1, Anchors::X, QStringLiteral("3200")));
    QCOMPARE(m_edited.size(), std::size_t{1});
    QCOMPARE(m_edited[0].first[1].x, 3.2);
    QCOMPARE(cell("anchorTable", 1, Anchors::X), QStringLiteral("3,200"));
    QVERIFY(m_window->isWindowModified());
    QVERIFY(note("anchorsDock").contains(QStringLiteral("not saved")));
    QCOMPARE(find<QAction>("undoUwbAction")->toolTip(), QStringLiteral("Undo: Move A1"));
    QVERIFY(undoes(plant.anchors, plant.uwb));
    QCOMPARE(cell("anchorTable", 1, Anchors::X), QStringLiteral("3,150"));
    QVERIFY(!m_window->isWindowModified());
    trigger("redoUwbAction");
    QCOMPARE(m_edited.back().first[1].x, 3.2);
}

void UwbPanelTest::addingAndRemovingAnAnchorIsUndone()
{
    openRunning();
    const PlantLayout plant = scenes::uwbPlant();
    trigger("addAnchorAction");
    QCOMPARE(m_edited.back().first.size(), std::size_t{5});
    QCOMPARE(m_edited.back().first[4].id, 4);
    QCOMPARE(m_edited.back().first[4].label, std::string("A4"));
    QVERIFY(undoes(plant.anchors, plant.uwb));
    QVERIFY(!find<QAction>("removeAnchorAction")->isEnabled());
    find<HintTableView>("anchorTable")->selectRow(0);
    QVERIFY(find<QAction>("removeAnchorAction")->isEnabled());
    trigger("removeAnchorAction");
    QCOMPARE(m_edited.back().first.size(), std::size_t{3});
    QCOMPARE(cell("anchorTable", 0, Anchors::Label), QStringLiteral("A1"));
    QVERIFY(undoes(plant.anchors, plant.uwb));
}

void UwbPanelTest::aRemovedAnchorTakesItsCorrectionsAlongAndUndoBringsThemBack()
{
    openRunning();
    const PlantLayout plant = scenes::uwbPlant();
    find<HintTableView>("anchorTable")->selectRow(1);
    trigger("removeAnchorAction");
    QVERIFY(m_edited.back().second.corrections.empty());
    QVERIFY(undoes(plant.anchors, plant.uwb));
}

void UwbPanelTest::aRenumberedAnchorKeepsItsCorrections()
{
    openRunning();
    QVERIFY(enter("anchorTable", 1, Anchors::Id, QStringLiteral("11")));
    QVERIFY((m_edited.back().second.corrections == std::vector<RangeCorrection>{{11, 0, -0.052}}));
}

void UwbPanelTest::everyEditIsAnEntryOfItsOwn()
{
    openRunning();
    for (const char* x : {"3200", "3210", "3220"})
        QVERIFY(enter("anchorTable", 1, Anchors::X, QString::fromLatin1(x)));
    trigger("undoUwbAction");
    QCOMPARE(m_edited.back().first[1].x, 3.21);
    trigger("undoUwbAction");
    QCOMPARE(m_edited.back().first[1].x, 3.2);
}

void UwbPanelTest::tagsAreAddedEditedAndRemovedWithUndo()
{
    openRunning();
    const PlantLayout plant = scenes::uwbPlant();
    trigger("addTagAction");
    QCOMPARE(m_edited.back().second.tags.size(), std::size_t{2});
    QCOMPARE(m_edited.back().second.tags[1].id, 1);
    QVERIFY(undoes(plant.anchors, plant.uwb));
    QVERIFY(enter("uwbTagTable", 0, Tags::Agv, QStringLiteral("AGV 3")));
    QCOMPARE(m_edited.back().second.tags[0].agv, std::optional(RobotId{3}));
    QVERIFY(undoes(plant.anchors, plant.uwb));
    QVERIFY(enter("uwbTagTable", 1, Tags::Label, QStringLiteral("Fork"))); // T5 is only heard
    QCOMPARE(m_edited.back().second.tags[1].label, std::string("Fork"));
    QVERIFY(undoes(plant.anchors, plant.uwb));
    find<HintTableView>("uwbTagTable")->selectRow(0);
    trigger("removeTagAction");
    QVERIFY(m_edited.back().second.tags.empty());
    QVERIFY(m_edited.back().second.corrections.empty());
    QVERIFY(undoes(plant.anchors, plant.uwb));
}

void UwbPanelTest::aTagThatIsOnlyHeardCannotBeRemoved()
{
    openRunning();
    find<HintTableView>("uwbTagTable")->selectRow(1);
    QVERIFY(!find<QAction>("removeTagAction")->isEnabled());
}

void UwbPanelTest::refusedInputLeavesASentenceAndTheListAsItWas()
{
    openRunning();
    raise("anchorsDock");
    QVERIFY(!enter("anchorTable", 0, Anchors::Id, QStringLiteral("2")));
    QVERIFY(m_edited.empty());
    QCOMPARE(cell("anchorTable", 0, Anchors::Id), QStringLiteral("0"));
    QVERIFY(note("anchorsDock").contains(QStringLiteral("There is an anchor 2 already")));
    // The next good input takes the sentence away.
    QVERIFY(enter("anchorTable", 0, Anchors::Id, QStringLiteral("9")));
    QVERIFY(!note("anchorsDock").contains(QStringLiteral("already")));
}

void UwbPanelTest::theMapShowsAnAnchorWhereItWasMovedTo()
{
    openRunning();
    auto* map = find<MapWidget>("map");
    const Viewport before = map->viewport();
    const QPointF target = before.toPixels(Point2{1.0, 3.05});
    QVERIFY(!map->detailsAt(target).contains(QStringLiteral("A0")));
    QVERIFY(enter("anchorTable", 0, Anchors::X, QStringLiteral("1000")));
    QVERIFY(enter("anchorTable", 0, Anchors::Y, QStringLiteral("3050")));
    QVERIFY2(map->detailsAt(target).contains(QStringLiteral("A0")), qPrintable(map->detailsAt(target)));
    QVERIFY(map->viewport() == before);
}

void UwbPanelTest::anImportIsOneEditAndShowsItsNotes()
{
    openRunning();
    const PlantLayout plant = scenes::uwbPlant();
    UwbSettings settings = plant.uwb;
    settings.tags.clear();
    settings.corrections.clear();
    m_window->takeImportedUwb({{6, "A6", 1.0, 2.0, 3.0, true}}, settings,
                              {QStringLiteral("Line 4 was left out")});
    QCOMPARE(m_edited.size(), std::size_t{1});
    QCOMPARE(cell("anchorTable", 0, Anchors::Id), QStringLiteral("6"));
    QVERIFY(note("anchorsDock").contains(QStringLiteral("Line 4 was left out")));
    QVERIFY(undoes(plant.anchors, plant.uwb));
}

void UwbPanelTest::anExportAndASaveCarryWhatIsShown()
{
    openRunning();
    QVERIFY(!find<QAction>("saveUwbAction")->isEnabled());
    QVERIFY(enter("anchorTable", 1, Anchors::X, QStringLiteral("3200")));
    QSignalSpy saves(m_window.get(), &MainWindow::saveUwbRequested);
    trigger("saveUwbAction");
    QCOMPARE(saves.count(), 1);
    QCOMPARE(saves[0][0].value<std::vector<UwbAnchor>>()[1].x, 3.2);
    m_window->showUwbSaved(true, QStringLiteral("Saved to plant.json"));
    QVERIFY(!m_window->isWindowModified());
    QCOMPARE(note("anchorsDock"), QStringLiteral("Saved to plant.json"));
    QVERIFY(find<QAction>("undoUwbAction")->isEnabled()); // a save is no end of undo
    trigger("undoUwbAction");
    QVERIFY(m_window->isWindowModified());
}

void UwbPanelTest::aFailedSaveKeepsTheEditsUnsavedAndSaysWhy()
{
    openRunning();
    trigger("addAnchorAction");
    trigger("saveUwbAction");
    m_window->showUwbSaved(false, QStringLiteral("plant.json cannot be written"));
    QVERIFY(m_window->isWindowModified());
    QCOMPARE(note("tagsDock"), QStringLiteral("plant.json cannot be written"));
    QVERIFY(find<QAction>("saveUwbAction")->isEnabled());
}

void UwbPanelTest::anEditDuringASaveStaysUnsaved()
{
    openRunning();
    trigger("addAnchorAction");
    trigger("saveUwbAction");
    trigger("addAnchorAction");
    m_window->showUwbSaved(true, QStringLiteral("Saved"));
    QVERIFY(m_window->isWindowModified());
}

void UwbPanelTest::closingWithUnsavedEditsAsks()
{
    openRunning();
    trigger("addAnchorAction");
    QVERIFY(!m_window->close());
    QVERIFY(m_window->isVisible());
    QVERIFY(!m_window->close()); // asked once
    QCOMPARE(m_window->findChildren<QMessageBox*>().size(), 1);
    click("stayButton");
    QVERIFY(m_window->isVisible());
    QTRY_VERIFY(!m_window->findChild<QMessageBox*>());
    QVERIFY(!m_window->close());
    click("discardAndCloseButton");
    QVERIFY(!m_window->isVisible());
}

void UwbPanelTest::withoutAPlantFileNothingIsSavedOrAskedAndTheNoteSaysSo()
{
    openRunning();
    m_window->setUwbSavable(false);
    trigger("addAnchorAction");
    QVERIFY(!find<QAction>("saveUwbAction")->isEnabled());
    QVERIFY(!m_window->isWindowModified());
    QVERIFY2(note("anchorsDock").contains("until the console ends"), qPrintable(note("anchorsDock")));
    QVERIFY(m_window->close());
}

void UwbPanelTest::closingCanSaveFirst()
{
    openRunning();
    trigger("addAnchorAction");
    QSignalSpy saves(m_window.get(), &MainWindow::saveUwbRequested);
    QVERIFY(!m_window->close());
    click("saveAndCloseButton");
    QCOMPARE(saves.count(), 1);
    QVERIFY(m_window->isVisible());
    m_window->showUwbSaved(true, QStringLiteral("Saved"));
    QVERIFY(!m_window->isVisible());
}

void UwbPanelTest::aFailedSaveKeepsTheWindowOpen()
{
    openRunning();
    trigger("addAnchorAction");
    QVERIFY(!m_window->close());
    click("saveAndCloseButton");
    m_window->showUwbSaved(false, QStringLiteral("The disk is full"));
    QVERIFY(m_window->isVisible());
    QCOMPARE(note("anchorsDock"), QStringLiteral("The disk is full"));
    // A later save by itself does not close the window.
    trigger("saveUwbAction");
    m_window->showUwbSaved(true, QStringLiteral("Saved"));
    QVERIFY(m_window->isVisible());
}

void UwbPanelTest::filesAreChosenInADialog()
{
    openRunning();
    QSignalSpy imports(m_window.get(), &MainWindow::importUwbRequested);
    QSignalSpy exports(m_window.get(), &MainWindow::exportUwbRequested);
    trigger("importUwbAction");
    emit find<QFileDialog>("importUwbDialog")->fileSelected(QStringLiteral("/tmp/anchors.csv"));
    QCOMPARE(imports.count(), 1);
    QCOMPARE(imports[0][0].toString(), QStringLiteral("/tmp/anchors.csv"));
    trigger("exportUwbAction");
    emit find<QFileDialog>("exportUwbDialog")->fileSelected(QStringLiteral("/tmp/out.csv"));
    QCOMPARE(exports.count(), 1);
    QVERIFY(exports[0][1].value<std::vector<UwbAnchor>>() == scenes::uwbPlant().anchors);
    m_window->showUwbNote(EventLevel::Warning, QStringLiteral("anchors.csv:3: no number"));
    QCOMPARE(note("anchorsDock"), QStringLiteral("anchors.csv:3: no number"));
}

void UwbPanelTest::thePanelsAreInTheViewMenuAndTheSavedLayout()
{
    openRunning();
    auto* dock = find<QDockWidget>("anchorsDock");
    QVERIFY(find<QWidget>("panelMenu")->actions().contains(dock->toggleViewAction()));
    // Behind the event log at first.
    QVERIFY(find<QDockWidget>("eventsDock")->visibleRegion().isEmpty() == false);
    QVERIFY(m_window->tabifiedDockWidgets(find<QDockWidget>("eventsDock")).contains(dock));
    dock->hide();
    m_window->close();
    open(scenes::uwbPlant());
    QVERIFY(find<QDockWidget>("anchorsDock")->isHidden());
    trigger("resetLayoutAction");
    QVERIFY(!find<QDockWidget>("anchorsDock")->isHidden());
}

void UwbPanelTest::everyEditIsAlsoInTheMenu()
{
    const QList<QAction*> actions = find<QWidget>("uwbMenu")->actions();
    for (const char* name :
         {"undoUwbAction", "redoUwbAction", "addAnchorAction", "removeAnchorAction", "addTagAction",
          "removeTagAction", "placeAnchorsAction", "calibrateRangesAction", "correctionsAction",
          "importUwbAction", "exportUwbAction", "saveUwbAction", "uwbPortAction"}) {
        const auto* action = find<QAction>(name);
        QVERIFY2(actions.contains(action), name);
        QVERIFY2(!action->toolTip().isEmpty(), name);
    }
    QCOMPARE(find<QAction>("undoUwbAction")->shortcut(), QKeySequence(Qt::CTRL | Qt::Key_Z));
    QCOMPARE(find<QAction>("redoUwbAction")->shortcut(), QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_Z));
}

void UwbPanelTest::theWindowFitsASmallScreenInGermanWithThePanelsInSight()
{
    setUpApplication(*qApp, QLocale(QStringLiteral("de_DE")));
    openRunning();
    for (const char* dock : {"anchorsDock", "tagsDock"}) {
        raise(dock);
        trigger("addAnchorAction"); // with the note about unsaved edits
        m_window->resize(960, 540);
        QCoreApplication::processEvents();
        QVERIFY2(m_window->width() <= 960 && m_window->height() <= 540,
                 qPrintable(QStringLiteral("%1 x %2").arg(m_window->width()).arg(m_window->height())));
    }
}

void UwbPanelTest::theLanguageChangesWhileThePanelsAreOpen()
{
    openRunning();
    trigger("addAnchorAction");
    setUpApplication(*qApp, QLocale(QStringLiteral("de_DE")));
    QTRY_VERIFY(note("anchorsDock").contains(QStringLiteral("nicht gespeichert")));
    QCOMPARE(find<QAction>("addAnchorAction")->iconText(), QStringLiteral("Anker hinzufügen"));
    QVERIFY(find<QAction>("undoUwbAction")->toolTip().startsWith(QStringLiteral("Rückgängig: ")));
    QCOMPARE(cell("uwbTagTable", 0, Tags::State), QStringLiteral("Position"));
    QVERIFY(m_window->windowTitle().endsWith(QStringLiteral("AGV-Leitstand")));
}

QTEST_MAIN(UwbPanelTest)
#include "test_uwb_panels.moc"
