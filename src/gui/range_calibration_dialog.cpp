// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/range_calibration_dialog.h"

#include "gui/choice_box.h"
#include "gui/dialog_parts.h"
#include "gui/hint_table_view.h"
#include "gui/uwb_editor.h"
#include "model/cell_input.h"
#include "model/floor_tag_search.h"
#include "model/messages.h"
#include "model/uwb_tag_table_model.h"
#include "model/words.h"

#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace agv::gui {

using model::Words;

namespace {

constexpr int mostUnansweredSnapshots = 30; ///< about a second
constexpr double weakSpread_m = 0.15;       ///< a blocked view, or a tag that was moved

QDoubleSpinBox* coordinateBox(const QString& prefix, const char* name)
{
    auto* box = new QDoubleSpinBox;
    box->setObjectName(QString::fromLatin1(name));
    box->setRange(-model::mostCoordinate_mm, model::mostCoordinate_mm);
    box->setDecimals(0);
    box->setPrefix(prefix + QLatin1Char(' '));
    box->setGroupSeparatorShown(true);
    box->setButtonSymbols(QAbstractSpinBox::NoButtons);
    box->setAccessibleName(RangeCalibrationDialog::tr("%1 of the known point in mm").arg(prefix));
    return box;
}

} // namespace

RangeCalibrationDialog::RangeCalibrationDialog(const PlantLayout& plant, UwbEditor& editor, QWidget* parent)
    : QDialog(parent),
      m_plant(plant),
      m_editor(editor)
{
    setWindowTitle(tr("Calibrate ranges"));
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    auto* intro = new QLabel(
        tr("Put the tag at a point whose place you know, with a free view of every anchor. Keep it "
           "still and step aside while ranges are collected."));
    intro->setWordWrap(true);
    intro->setProperty("role", QStringLiteral("muted"));
    layout->addWidget(intro);
    buildForm();
    buildResult();
    fillTags();
    fillAgvMenu();
    for (QPushButton* button : findChildren<QPushButton*>())
        button->setAutoDefault(false); // Enter ends the input of a field, no more
    setPhase(Phase::Choosing);
    resize(620, 520);
}

void RangeCalibrationDialog::buildForm()
{
    m_tag = new ChoiceBox;
    m_tag->setObjectName(QStringLiteral("calibratedTagCombo"));
    m_x = coordinateBox(QStringLiteral("x"), "pointXSpin");
    m_y = coordinateBox(QStringLiteral("y"), "pointYSpin");
    m_z = coordinateBox(QStringLiteral("z"), "pointZSpin");
    m_z->setToolTip(tr("Height of the tag's antenna above the floor"));
    m_seconds = new QSpinBox;
    m_seconds->setObjectName(QStringLiteral("secondsSpin"));
    m_seconds->setRange(5, 600);
    m_seconds->setValue(30);
    m_seconds->setSuffix(tr(" s"));
    m_seconds->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_useAgv = new QPushButton(tr("Place of an &AGV"));
    m_useAgv->setObjectName(QStringLiteral("useAgvButton"));
    m_useAgv->setToolTip(
        tr("Take over where an AGV stands now; with the tag's place on it, when it carries the tag"));
    m_agvMenu = new QMenu(m_useAgv);
    m_useAgv->setMenu(m_agvMenu);
    m_floorTag = new QLineEdit;
    m_floorTag->setObjectName(QStringLiteral("floorTagEdit"));
    m_floorTag->setPlaceholderText(tr("number or ID"));
    m_useFloorTag = new QPushButton(tr("Place of this &floor tag"));
    m_useFloorTag->setObjectName(QStringLiteral("useFloorTagButton"));
    m_useFloorTag->setToolTip(tr("Take over where the floor tag with this number or ID lies"));
    m_start = new QPushButton;
    m_start->setObjectName(QStringLiteral("collectButton"));

    auto* point = new QHBoxLayout;
    point->setSpacing(6);
    for (QDoubleSpinBox* box : {m_x, m_y, m_z})
        point->addWidget(box, 1);
    auto* sources = new QHBoxLayout;
    sources->setSpacing(6);
    sources->addWidget(m_useAgv);
    sources->addStretch();
    sources->addWidget(m_floorTag);
    sources->addWidget(m_useFloorTag);
    auto* collect = new QHBoxLayout;
    collect->addWidget(m_seconds);
    collect->addStretch();
    collect->addWidget(m_start);
    auto* form = new QFormLayout;
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setHorizontalSpacing(12);
    form->addRow(tr("&Tag"), m_tag);
    form->addRow(tr("Known point (mm)"), point);
    form->addRow(QString(), sources);
    form->addRow(tr("&Duration"), collect);
    static_cast<QLabel*>(form->labelForField(collect))->setBuddy(m_seconds);
    centreLabels(*form);
    static_cast<QVBoxLayout*>(layout())->addLayout(form);

    connect(m_tag, &QComboBox::currentIndexChanged, this, &RangeCalibrationDialog::onTagChosen);
    connect(m_agvMenu, &QMenu::aboutToShow, this, &RangeCalibrationDialog::fillAgvMenu);
    connect(m_useFloorTag, &QPushButton::clicked, this, &RangeCalibrationDialog::takeFloorTag);
    connect(m_floorTag, &QLineEdit::returnPressed, this, &RangeCalibrationDialog::takeFloorTag);
    connect(m_start, &QPushButton::clicked, this, &RangeCalibrationDialog::start);
}

void RangeCalibrationDialog::buildResult()
{
    m_progress = new QProgressBar;
    m_progress->setObjectName(QStringLiteral("collectProgress"));
    m_progress->setRange(0, 1000);
    m_progress->setTextVisible(false);
    m_progress->setAccessibleName(tr("Progress"));
    m_statusIcon = new QLabel;
    m_status = new QLabel;
    m_status->setObjectName(QStringLiteral("rangeStatusLabel"));
    m_status->setWordWrap(true);
    m_status->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* status = new QHBoxLayout;
    status->addWidget(m_statusIcon, 0, Qt::AlignTop);
    status->addWidget(m_status, 1);
    m_table = new HintTableView;
    m_table->setObjectName(QStringLiteral("rangeCalibrationTable"));
    m_table->setAccessibleName(tr("Corrections found"));
    m_table->setModel(&m_model);
    m_table->setHint(tr("No ranges yet. Choose the tag, enter where it stands, and start."));
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    m_accept = new QPushButton(tr("&Use these corrections"));
    m_accept->setProperty("primary", true);
    m_accept->setObjectName(QStringLiteral("acceptCorrectionsButton"));
    m_accept->setToolTip(tr("Put them into the correction table; one Undo takes them back"));
    m_discard = new QPushButton;
    m_discard->setObjectName(QStringLiteral("discardCorrectionsButton"));
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(m_accept);
    buttons->addWidget(m_discard);
    auto* outer = static_cast<QVBoxLayout*>(layout());
    outer->addWidget(m_progress);
    outer->addLayout(status);
    outer->addWidget(m_table, 1);
    outer->addLayout(buttons);
    connect(m_accept, &QPushButton::clicked, this, &RangeCalibrationDialog::accept);
    connect(m_discard, &QPushButton::clicked, this, &QDialog::reject);
}

void RangeCalibrationDialog::setTheme(const Theme& theme)
{
    m_theme = theme;
    setPalette(theme.toPalette());
    showStatus();
}

QString RangeCalibrationDialog::nameOf(int tag) const
{
    const std::vector<UwbTag>& tags = m_editor.settings().tags;
    const auto listed = std::ranges::find(tags, tag, &UwbTag::id);
    UwbTag unlisted;
    unlisted.id = tag;
    return model::uwbTagName(listed == tags.end() ? unlisted : *listed);
}

int RangeCalibrationDialog::chosenTag() const
{
    return m_tag->currentIndex() < 0 ? -1 : m_tag->currentData().toInt();
}

void RangeCalibrationDialog::fillTags()
{
    std::vector<int> ids;
    for (const UwbTag& tag : m_editor.settings().tags)
        ids.push_back(tag.id);
    if (m_snapshot.uwb) {
        for (const UwbTagSnapshot& tag : m_snapshot.uwb->tags) {
            if (std::ranges::find(ids, tag.id) == ids.end())
                ids.push_back(tag.id);
        }
    }
    for (int id : ids) {
        if (m_tag->findData(id) < 0)
            m_tag->addItem(nameOf(id), id);
    }
}

void RangeCalibrationDialog::fillAgvMenu()
{
    m_agvMenu->clear();
    for (const AgvSnapshot& agv : m_snapshot.agvs) {
        if (agv.pose)
            m_agvMenu->addAction(QString::fromStdString(agv.name), this,
                                 [this, id = agv.id] { takeAgv(id); });
    }
    if (m_agvMenu->isEmpty())
        m_agvMenu->addAction(tr("No AGV is located yet: calibrate one first"))->setEnabled(false);
}

void RangeCalibrationDialog::onTagChosen()
{
    const std::vector<UwbTag>& tags = m_editor.settings().tags;
    const auto listed = std::ranges::find(tags, chosenTag(), &UwbTag::id);
    m_z->setValue(mmFromMetres(listed == tags.end() ? m_editor.settings().tagHeight_m : listed->z_m));
    showStatus();
}

void RangeCalibrationDialog::setPoint(Point2 point)
{
    m_x->setValue(std::round(mmFromMetres(point.x)));
    m_y->setValue(std::round(mmFromMetres(point.y)));
}

void RangeCalibrationDialog::takeAgv(RobotId id)
{
    const auto agv = std::ranges::find(m_snapshot.agvs, id, &AgvSnapshot::id);
    if (agv == m_snapshot.agvs.end() || !agv->pose)
        return;
    const std::vector<UwbTag>& tags = m_editor.settings().tags;
    const auto tag = std::ranges::find(tags, chosenTag(), &UwbTag::id);
    const bool carried = tag != tags.end() && tag->agv == id;
    setPoint(carried ? fromVehicleFrame(*agv->pose, tag->mount) : agv->pose->position);
}

void RangeCalibrationDialog::takeFloorTag()
{
    const std::vector<const FloorTag*> found = model::floorTagsNamed(m_floorTag->text(), m_plant);
    if (found.size() == 1)
        setPoint(found.front()->position);
    m_pointNote =
        found.size() == 1 ? QString()
        : found.empty()
            ? tr("There is no floor tag \"%1\".").arg(m_floorTag->text())
            : tr("%1 floor tags end in \"%2\": enter more digits.").arg(found.size()).arg(m_floorTag->text());
    showStatus();
}

void RangeCalibrationDialog::start()
{
    if (m_phase == Phase::Asked || m_phase == Phase::Collecting) {
        emit cancelRequested();
        return setPhase(Phase::Choosing);
    }
    m_before = m_snapshot.uwb ? m_snapshot.uwb->calibration : RangeCalibrationSnapshot{};
    m_waited = 0;
    m_pointNote.clear();
    m_model.clear();
    setPhase(Phase::Asked);
    emit startRequested(chosenTag(), metresFromMm(m_x->value()), metresFromMm(m_y->value()),
                        metresFromMm(m_z->value()), m_seconds->value());
}

void RangeCalibrationDialog::showSnapshot(const PlantSnapshot& snapshot)
{
    m_snapshot = snapshot;
    fillTags();
    if (snapshot.uwb)
        follow(snapshot.uwb->calibration);
    showStatus();
}

void RangeCalibrationDialog::follow(const RangeCalibrationSnapshot& calibration)
{
    if (m_phase != Phase::Asked && m_phase != Phase::Collecting)
        return;
    // The snapshots on their way when collecting was asked for still tell of the time before.
    if (m_phase == Phase::Asked && calibration == m_before && ++m_waited < mostUnansweredSnapshots)
        return;
    m_result = calibration;
    m_model.setResult(m_editor.anchors(), m_editor.settings().corrections, calibration);
    m_progress->setValue(static_cast<int>(std::lround(1000.0 * calibration.progress)));
    switch (calibration.state) {
    case RangeCalibrationState::Collecting:
        return setPhase(Phase::Collecting);
    case RangeCalibrationState::Finished:
        return setPhase(Phase::Finished);
    case RangeCalibrationState::Failed:
        return setPhase(Phase::Failed);
    case RangeCalibrationState::Idle:
        return setPhase(Phase::Choosing);
    }
}

void RangeCalibrationDialog::setPhase(Phase phase)
{
    m_phase = phase;
    const bool running = phase == Phase::Asked || phase == Phase::Collecting;
    for (QWidget* field : std::initializer_list<QWidget*>{m_tag, m_x, m_y, m_z, m_seconds, m_useAgv,
                                                          m_floorTag, m_useFloorTag})
        field->setEnabled(!running);
    m_start->setText(running ? tr("&Cancel") : phase == Phase::Choosing ? tr("&Start") : tr("&Start again"));
    m_start->setToolTip(running ? tr("Give up this collection")
                                : tr("Collect ranges of the tag at the known point"));
    const bool result = phase == Phase::Finished;
    m_accept->setEnabled(result && std::ranges::any_of(m_result.rows, [](const RangeCalibrationRow& row) {
                             return row.offset_m.has_value();
                         }));
    m_discard->setText(result ? tr("&Discard") : tr("&Close"));
    m_discard->setToolTip(tr("Close; the correction table stays as it is"));
    if (!running && phase != Phase::Finished)
        m_progress->setValue(0);
    showStatus();
}

QString RangeCalibrationDialog::obstacle() const
{
    if (m_editor.anchors().empty())
        return tr("There are no anchors. Add them in the panel UWB anchors.");
    if (!m_snapshot.uwb || !isConnected(m_snapshot.uwb->link))
        return tr("The UWB unit is not connected. Open it in the panel Links.");
    if (chosenTag() < 0)
        return tr("No tag is listed or heard. Switch the tag on, or add it in the panel UWB tags.");
    return {};
}

void RangeCalibrationDialog::showStatus()
{
    const QString hindrance = obstacle();
    const bool running = m_phase == Phase::Asked || m_phase == Phase::Collecting;
    m_start->setEnabled(running || hindrance.isEmpty());
    const QString reason = model::Messages::sentence(m_result.reason);
    const bool weak = std::ranges::any_of(
        m_result.rows, [](const RangeCalibrationRow& row) { return row.spread_m > weakSpread_m; });
    Glyph glyph = Glyph::Info;
    QString text;
    if (m_phase == Phase::Failed) {
        glyph = Glyph::Error;
        text = tr("No corrections: %1").arg(reason);
    } else if (m_phase == Phase::Finished) {
        glyph = reason.isEmpty() && !weak ? Glyph::Check : Glyph::Warning;
        text = tr("Finished. Look at the spread, then use or discard the corrections of %1.")
                   .arg(nameOf(m_result.tag));
        if (!reason.isEmpty())
            text = reason;
        else if (weak)
            text = tr("Finished, but some ranges vary much: was the view blocked, or the tag moved?");
    } else if (!hindrance.isEmpty()) {
        glyph = Glyph::Warning;
        text = hindrance;
    } else if (!m_pointNote.isEmpty()) {
        glyph = Glyph::Warning;
        text = m_pointNote;
    } else {
        text = running ? tr("Collecting ranges of %1: leave the tag where it is.").arg(nameOf(chosenTag()))
                       : tr("Enter where the antenna of the tag is, then start.");
    }
    m_status->setText(text);
    showStatusGlyph(*m_statusIcon, glyph, m_theme);
}

void RangeCalibrationDialog::accept()
{
    if (m_phase != Phase::Finished) // Enter in a field must not close the dialog
        return;
    m_editor.setCorrections(tr("Calibrate ranges of %1").arg(nameOf(m_result.tag)),
                            model::corrected(m_editor.settings().corrections, m_result));
    done(Accepted);
}

void RangeCalibrationDialog::done(int result)
{
    if (m_phase == Phase::Asked || m_phase == Phase::Collecting)
        emit cancelRequested();
    m_phase = Phase::Choosing;
    QDialog::done(result);
}

} // namespace agv::gui
