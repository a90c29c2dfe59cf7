// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPointer>

#include "core/anchor_survey.h"
#include "core/snapshot.h"
#include "gui/theme.h"
#include "gui/uwb_editor.h"
#include "model/anchor_table_model.h"
#include "model/uwb_tag_table_model.h"

#include <optional>
#include <vector>

namespace Ui {
class MainWindow;
}

namespace agv::gui {

class AnchorSurveyDialog;
class CorrectionDialog;
class MainWindow;
class RangeCalibrationDialog;
class SerialPortDialog;
class UwbTablePanel;

/// The window's UWB part: the panels of anchors and tags, their dialogs (never modal: Stop all stays in
/// reach), the undo list, files. Speaks to the application through the signals of MainWindow. GUI thread.
class UwbScreens : public QObject {
    Q_OBJECT
public:
    UwbScreens(Ui::MainWindow& ui, MainWindow* window);
    ~UwbScreens() override;

    void setPlant(const PlantLayout& plant);
    void setTheme(const Theme& theme);
    void showSnapshot(const PlantSnapshot& snapshot);
    void retranslate();

    void takeImported(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings,
                      const QStringList& notes);
    /// The answer to saveUwbRequested(). `sentence` is shown; plain English or the language of the program.
    void showSaved(bool saved, const QString& sentence);
    void showNote(EventLevel level, const QString& sentence);
    void showSurvey(const AnchorSurvey& survey);
    void showPorts(const std::vector<SerialPortInfo>& ports);

    /// False: edits hold for this session only; nothing asks about them.
    void setSavable(bool savable);

    UwbEditor& editor() { return m_editor; }
    /// True when the window may close now. Else the operator is asked about unsaved edits, and the window is
    /// closed again after the answer.
    bool mayClose();

private:
    void buildPanels();
    void connectModels();
    void moveAnchor(int id, Point2 place);
    void connectActions();
    void connectUndo();
    void updateUndo();
    void onEdited();
    void updateHints();
    void updateActions();
    void setPanelNotes(const QString& text, bool isWarning);
    void showState(); ///< the note that tells of unsaved edits
    void removeChosenAnchors();
    void removeChosenTags();
    void importFile();
    void exportFile();
    void save();
    void openCorrections();
    void openCalibration();
    void openSurvey();
    void openPorts();
    void updateDialogs();
    void updateDialogThemes();

    Ui::MainWindow& m_ui;
    MainWindow* m_window;
    UwbEditor m_editor;
    model::AnchorTableModel m_anchors;
    model::UwbTagTableModel m_tags;
    PlantLayout m_plant;
    PlantSnapshot m_snapshot;
    Theme m_theme = Theme::light();
    std::optional<UwbEditor::Kit> m_saving; ///< what saveUwbRequested() carried, until it is answered
    bool m_closeWhenSaved = false;
    bool m_discardEdits = false;
    bool m_isSavable = true;
    QPointer<CorrectionDialog> m_corrections;
    QPointer<RangeCalibrationDialog> m_calibration;
    QPointer<AnchorSurveyDialog> m_survey;
    QPointer<SerialPortDialog> m_ports;
};

} // namespace agv::gui
