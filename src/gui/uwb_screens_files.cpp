// SPDX-License-Identifier: GPL-3.0-or-later
// Files and dialogs of UwbScreens.
#include "gui/anchor_survey_dialog.h"
#include "gui/correction_dialog.h"
#include "gui/main_window.h"
#include "gui/range_calibration_dialog.h"
#include "gui/serial_port_dialog.h"
#include "gui/uwb_screens.h"
#include "model/messages.h"

#include <QFileDialog>
#include <QMessageBox>
#include <QPushButton>

#include <utility>

namespace agv::gui {
namespace {

/// Shows the dialog of `place`, a new one when there is none.
template<typename Dialog, typename Make>
Dialog* raised(QPointer<Dialog>& place, const Make& make)
{
    if (!place) {
        place = make();
        place->setAttribute(Qt::WA_DeleteOnClose);
    }
    place->show();
    place->raise();
    place->activateWindow();
    return place;
}

} // namespace

void UwbScreens::updateDialogThemes()
{
    if (m_corrections)
        m_corrections->setTheme(m_theme);
    if (m_calibration)
        m_calibration->setTheme(m_theme);
    if (m_survey)
        m_survey->setTheme(m_theme);
    if (m_ports)
        m_ports->setTheme(m_theme);
}

void UwbScreens::updateDialogs()
{
    const UwbSnapshot* uwb = m_snapshot.uwb ? &*m_snapshot.uwb : nullptr;
    if (m_corrections)
        m_corrections->showUwb(uwb);
    if (m_calibration)
        m_calibration->showSnapshot(m_snapshot);
    if (m_ports)
        m_ports->showUwb(uwb);
}

void UwbScreens::openCorrections()
{
    raised(m_corrections, [this] { return new CorrectionDialog(m_editor, m_window); });
    updateDialogThemes();
    updateDialogs();
}

void UwbScreens::openCalibration()
{
    raised(m_calibration, [this] {
        auto* dialog = new RangeCalibrationDialog(m_plant, m_editor, m_window);
        connect(dialog, &RangeCalibrationDialog::startRequested, m_window,
                &MainWindow::startRangeCalibrationRequested);
        connect(dialog, &RangeCalibrationDialog::cancelRequested, m_window,
                &MainWindow::cancelRangeCalibrationRequested);
        return dialog;
    });
    updateDialogThemes();
    updateDialogs();
}

void UwbScreens::openSurvey()
{
    raised(m_survey, [this] {
        auto* dialog = new AnchorSurveyDialog(m_editor, m_window);
        connect(dialog, &AnchorSurveyDialog::surveyRequested, m_window, &MainWindow::surveyAnchorsRequested);
        return dialog;
    });
    updateDialogThemes();
    emit m_window->surveyAnchorsRequested();
}

void UwbScreens::openPorts()
{
    raised(m_ports, [this] {
        auto* dialog = new SerialPortDialog(m_editor.settings().port, m_editor.settings().dialect, m_window);
        connect(dialog, &SerialPortDialog::portsRequested, m_window, &MainWindow::serialPortsRequested);
        connect(dialog, &SerialPortDialog::askRequested, m_window, &MainWindow::askUwbRequested);
        connect(dialog, &SerialPortDialog::chosen, this,
                [this](const SerialPortChoice& port, std::optional<UwbDialect> dialect) {
                    m_editor.setPort(port, dialect);
                    emit m_window->uwbPortChosen(port, dialect);
                });
        return dialog;
    });
    updateDialogThemes();
    updateDialogs();
    emit m_window->serialPortsRequested();
}

void UwbScreens::showSurvey(const AnchorSurvey& survey)
{
    if (m_survey)
        m_survey->showSurvey(survey);
}

void UwbScreens::showPorts(const std::vector<SerialPortInfo>& ports)
{
    if (m_ports)
        m_ports->showPorts(ports);
}

void UwbScreens::importFile()
{
    auto* dialog = new QFileDialog(m_window, tr("Import anchors and tags"));
    dialog->setObjectName(QStringLiteral("importUwbDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setFileMode(QFileDialog::ExistingFile);
    dialog->setNameFilters(
        {tr("Anchor lists and plant files (*.csv *.xml *.json *.cfg *.txt)"), tr("All files (*)")});
    connect(dialog, &QFileDialog::fileSelected, m_window, &MainWindow::importUwbRequested);
    dialog->open();
}

void UwbScreens::exportFile()
{
    auto* dialog = new QFileDialog(m_window, tr("Export anchors"));
    dialog->setObjectName(QStringLiteral("exportUwbDialog"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters(
        {tr("Anchor list (*.csv)"), tr("Anchors of DecaRangeRTLS (*.xml)"), tr("All files (*)")});
    dialog->setDefaultSuffix(QStringLiteral("csv"));
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.contains(QLatin1String("*.xml")) ? QStringLiteral("xml")
                                                                         : QStringLiteral("csv"));
    });
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        emit m_window->exportUwbRequested(path, m_editor.anchors(), m_editor.settings());
    });
    dialog->open();
}

void UwbScreens::takeImported(const std::vector<UwbAnchor>& anchors, const UwbSettings& settings,
                              const QStringList& notes)
{
    m_editor.edit(tr("Import anchors and tags"), {anchors, settings});
    QStringList lines{tr("Imported: anchors %1, tags %2. Undo takes the import back.")
                          .arg(anchors.size())
                          .arg(settings.tags.size())};
    for (const QString& note : notes)
        lines << model::Messages::sentence(note.toStdString());
    setPanelNotes(lines.join(QLatin1Char('\n')), !notes.isEmpty());
}

void UwbScreens::save()
{
    m_saving = m_editor.kit();
    updateActions();
    emit m_window->saveUwbRequested(m_editor.anchors(), m_editor.settings());
}

void UwbScreens::showSaved(bool saved, const QString& sentence)
{
    // An edit that was made while the file was being written is not in it.
    if (saved && m_saving && *m_saving == m_editor.kit())
        m_editor.setSaved();
    m_saving.reset();
    updateActions();
    setPanelNotes(model::Messages::sentence(sentence.toStdString()), !saved);
    if (std::exchange(m_closeWhenSaved, false) && saved)
        m_window->close();
}

void UwbScreens::showNote(EventLevel level, const QString& sentence)
{
    setPanelNotes(model::Messages::sentence(sentence.toStdString()), level >= EventLevel::Warning);
}

bool UwbScreens::mayClose()
{
    if (!m_isSavable || !m_editor.hasUnsavedEdits() || m_discardEdits)
        return true;
    if (m_window->findChild<QMessageBox*>(QStringLiteral("unsavedUwbBox")))
        return false;
    auto* box = new QMessageBox(QMessageBox::Question, tr("Unsaved edits"),
                                tr("The UWB anchors and tags were edited but not saved to the plant file."),
                                QMessageBox::NoButton, m_window);
    box->setObjectName(QStringLiteral("unsavedUwbBox"));
    box->setAttribute(Qt::WA_DeleteOnClose);
    QPushButton* saveButton = box->addButton(tr("&Save and close"), QMessageBox::AcceptRole);
    QPushButton* discardButton = box->addButton(tr("&Discard and close"), QMessageBox::DestructiveRole);
    QPushButton* stayButton = box->addButton(tr("Go &back"), QMessageBox::RejectRole);
    saveButton->setObjectName(QStringLiteral("saveAndCloseButton"));
    discardButton->setObjectName(QStringLiteral("discardAndCloseButton"));
    stayButton->setObjectName(QStringLiteral("stayButton"));
    box->setDefaultButton(saveButton);
    box->setEscapeButton(stayButton);
    connect(saveButton, &QPushButton::clicked, this, [this] {
        m_closeWhenSaved = true;
        save();
    });
    connect(discardButton, &QPushButton::clicked, this, [this] {
        m_discardEdits = true;
        m_window->close();
    });
    box->open();
    return false;
}

} // namespace agv::gui
