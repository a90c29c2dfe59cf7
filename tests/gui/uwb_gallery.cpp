// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/uwb_gallery.h"

#include "gui/anchor_survey_dialog.h"
#include "gui/correction_dialog.h"
#include "gui/hint_table_view.h"
#include "gui/main_window.h"
#include "gui/range_calibration_dialog.h"
#include "gui/scenes.h"
#include "gui/serial_port_dialog.h"
#include "gui/uwb_scenes.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QPushButton>
#include <QSettings>

using namespace agv;

namespace {

class Pictures {
public:
    Pictures(const QString& folder, const QString& suffix, const PlantLayout& plant, QSize size)
        : m_place(folder + QStringLiteral("/uwb-%1-") + suffix + QStringLiteral(".png")),
          m_window(plant)
    {
        m_window.resize(size);
        m_window.show();
    }
    gui::MainWindow& window() { return m_window; }
    template<typename T>
    T* find(const char* name) const
    {
        return m_window.findChild<T*>(QString::fromLatin1(name));
    }
    void trigger(const char* action) const { find<QAction>(action)->trigger(); }
    void save(QWidget* widget, const char* name) const
    {
        for (int i = 0; i < 5; ++i)
            QApplication::processEvents();
        widget->grab().save(m_place.arg(QString::fromLatin1(name)));
    }
    void raise(const char* dock) const { find<QDockWidget>(dock)->raise(); }

private:
    QString m_place;
    gui::MainWindow m_window;
};

void saveCalibration(Pictures& pictures)
{
    pictures.trigger("calibrateRangesAction");
    auto* dialog = pictures.window().findChild<gui::RangeCalibrationDialog*>();
    pictures.save(dialog, "calibrate-1-start");
    const auto show = [&](RangeCalibrationState state, double progress, const char* name) {
        pictures.window().showSnapshot(scenes::uwbCalibrating(state, progress));
        pictures.save(dialog, name);
    };
    pictures.find<QPushButton>("collectButton")->click();
    show(RangeCalibrationState::Collecting, 0.4, "calibrate-2-collecting");
    show(RangeCalibrationState::Finished, 1.0, "calibrate-3-finished");
    pictures.find<QPushButton>("collectButton")->click();
    show(RangeCalibrationState::Failed, 0.0, "calibrate-4-failed");
    dialog->close();
}

void savePorts(Pictures& pictures)
{
    pictures.trigger("uwbPortAction");
    pictures.window().showSerialPorts(
        {{"/dev/ttyS0", "", {}, ""},
         {"/dev/ttyUSB0", "CP2102 USB to UART Bridge", UsbId{0x10c4, 0xea60}, "0001"},
         {"/dev/ttyACM0", "STM32 Virtual COM Port", trekUsbId, "3061"}});
    pictures.save(pictures.window().findChild<gui::SerialPortDialog*>(), "port");
}

} // namespace

void saveUwbPictures(const QString& folder, const QString& suffix, QSize windowSize)
{
    QSettings().clear();
    {
        Pictures empty(folder, suffix, scenes::wholePlant(), windowSize);
        empty.raise("tagsDock");
        empty.raise("anchorsDock");
        empty.save(&empty.window(), "empty");
    }
    QSettings().clear();
    Pictures pictures(folder, suffix, scenes::uwbPlant(), windowSize);
    pictures.window().showSnapshot(scenes::uwbRunning());
    pictures.find<gui::HintTableView>("linkTable")->selectRow(8);
    pictures.raise("anchorsDock");
    pictures.save(&pictures.window(), "anchors");
    pictures.raise("tagsDock");
    pictures.save(&pictures.window(), "tags");
    auto* anchors = pictures.find<gui::HintTableView>("anchorTable");
    anchors->model()->setData(anchors->model()->index(1, 2), QStringLiteral("3200"), Qt::EditRole);
    anchors->model()->setData(anchors->model()->index(1, 0), QStringLiteral("2"), Qt::EditRole);
    pictures.raise("anchorsDock");
    pictures.save(&pictures.window(), "anchors-refused");
    pictures.trigger("correctionsAction");
    pictures.save(pictures.window().findChild<gui::CorrectionDialog*>(), "corrections");
    pictures.trigger("placeAnchorsAction");
    pictures.window().showAnchorSurvey(scenes::uwbSurvey());
    pictures.save(pictures.window().findChild<gui::AnchorSurveyDialog*>(), "place");
    AnchorSurvey none;
    none.trouble = "Only 2 anchors range each other: three are needed";
    pictures.window().showAnchorSurvey(none);
    pictures.save(pictures.window().findChild<gui::AnchorSurveyDialog*>(), "place-failed");
    saveCalibration(pictures);
    savePorts(pictures);
}
