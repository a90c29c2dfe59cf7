// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/anchor_survey_dialog.h"

#include "gui/anchor_survey_view.h"
#include "gui/choice_box.h"
#include "gui/dialog_parts.h"
#include "gui/uwb_editor.h"
#include "model/anchor_table_model.h"
#include "model/messages.h"
#include "model/words.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>

namespace agv::gui {

using model::Words;

AnchorSurveyDialog::AnchorSurveyDialog(UwbEditor& editor, QWidget* parent)
    : QDialog(parent),
      m_editor(editor),
      m_view(new AnchorSurveyView),
      m_frame(new ChoiceBox),
      m_flip(new QCheckBox(tr("&Flip east and west"))),
      m_rotation(new QDoubleSpinBox),
      m_icon(new QLabel),
      m_status(new QLabel),
      m_again(new QPushButton(tr("&Measure again"))),
      m_accept(new QPushButton(tr("&Move the anchors"))),
      m_discard(new QPushButton(tr("&Discard")))
{
    setWindowTitle(tr("Place anchors"));
    buildControls();
    auto* intro = new QLabel(
        tr("Places found from the ranges between the anchors. Hollow: where the list has an anchor "
           "now. Filled: where it would go, and how far. Heights stay as they are."));
    intro->setWordWrap(true);
    intro->setProperty("role", QStringLiteral("muted"));
    auto* frame = new QHBoxLayout;
    auto* frameLabel = new QLabel(tr("&Lay it"));
    frameLabel->setBuddy(m_frame);
    auto* rotationLabel = new QLabel(tr("&Turn by"));
    rotationLabel->setBuddy(m_rotation);
    frame->addWidget(frameLabel);
    frame->addWidget(m_frame, 1);
    frame->addSpacing(12);
    frame->addWidget(m_flip);
    frame->addSpacing(12);
    frame->addWidget(rotationLabel);
    frame->addWidget(m_rotation);
    auto* status = new QHBoxLayout;
    status->addWidget(m_icon, 0, Qt::AlignTop);
    status->addWidget(m_status, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_again);
    buttons->addStretch();
    buttons->addWidget(m_accept);
    buttons->addWidget(m_discard);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(intro);
    layout->addLayout(frame);
    layout->addWidget(m_view, 1);
    layout->addLayout(status);
    layout->addLayout(buttons);
    resize(720, 560);
    fillOrigins();
    update();
}

void AnchorSurveyDialog::buildControls()
{
    m_view->setObjectName(QStringLiteral("surveyView"));
    m_frame->setObjectName(QStringLiteral("surveyFrameCombo"));
    m_frame->setToolTip(tr("Closest to the present list, or with one anchor as the origin of the plant"));
    m_flip->setObjectName(QStringLiteral("surveyFlipCheck"));
    m_flip->setToolTip(tr("Ranges alone do not tell a plan from its mirror image"));
    m_rotation->setObjectName(QStringLiteral("surveyRotationSpin"));
    m_rotation->setRange(-180.0, 180.0);
    m_rotation->setDecimals(1);
    m_rotation->setSuffix(QStringLiteral(" °"));
    m_rotation->setToolTip(tr("Counter-clockwise"));
    m_rotation->setButtonSymbols(QAbstractSpinBox::NoButtons);
    m_status->setObjectName(QStringLiteral("surveyStatusLabel"));
    m_status->setWordWrap(true);
    m_status->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_again->setObjectName(QStringLiteral("surveyAgainButton"));
    m_again->setToolTip(tr("Compute the places from the newest ranges between the anchors"));
    m_accept->setProperty("primary", true);
    m_accept->setObjectName(QStringLiteral("moveAnchorsButton"));
    m_accept->setToolTip(tr("Put the proposed places into the list; one Undo takes them back"));
    m_discard->setObjectName(QStringLiteral("discardSurveyButton"));
    m_discard->setToolTip(tr("Close; the anchors stay where they are"));
    for (QPushButton* button : {m_again, m_accept, m_discard})
        button->setAutoDefault(false);
    connect(m_frame, &QComboBox::currentIndexChanged, this, &AnchorSurveyDialog::update);
    connect(m_flip, &QCheckBox::toggled, this, &AnchorSurveyDialog::update);
    connect(m_rotation, &QDoubleSpinBox::valueChanged, this, &AnchorSurveyDialog::update);
    connect(&m_editor, &UwbEditor::edited, this, &AnchorSurveyDialog::update);
    connect(m_accept, &QPushButton::clicked, this, &AnchorSurveyDialog::accept);
    connect(m_discard, &QPushButton::clicked, this, &QDialog::reject);
    connect(m_again, &QPushButton::clicked, this, [this] {
        m_survey.reset();
        update();
        emit surveyRequested();
    });
}

void AnchorSurveyDialog::setTheme(const Theme& theme)
{
    m_theme = theme;
    setPalette(theme.toPalette());
    m_view->setTheme(theme);
    showNotes();
}

void AnchorSurveyDialog::showSurvey(const AnchorSurvey& survey)
{
    m_survey = survey;
    fillOrigins();
    update();
}

/// The choice stays where its anchor was surveyed again.
void AnchorSurveyDialog::fillOrigins()
{
    const QSignalBlocker blocker(m_frame);
    const QVariant chosen = m_frame->currentData();
    m_frame->clear();
    m_frame->addItem(tr("closest to the present list"));
    for (const UwbAnchor& anchor : m_editor.anchors()) {
        if (m_survey &&
            std::ranges::find(m_survey->anchors, anchor.id, &SurveyedAnchor::id) != m_survey->anchors.end())
            m_frame->addItem(tr("with %1 at the origin").arg(model::anchorName(anchor)), anchor.id);
    }
    m_frame->setCurrentIndex(std::max(0, chosen.isValid() ? m_frame->findData(chosen) : 0));
}

model::SurveyPlacement AnchorSurveyDialog::placement() const
{
    const QVariant origin = m_frame->currentData();
    return {.originAnchor = origin.isValid() ? std::optional(origin.toInt()) : std::nullopt,
            .flipped = m_flip->isChecked(),
            .rotation = radFromDeg(m_rotation->value())};
}

std::vector<UwbAnchor> AnchorSurveyDialog::proposal() const
{
    const std::vector<UwbAnchor>& present = m_editor.anchors();
    return isPlaced() ? placed(*m_survey, model::frameOf(*m_survey, present, placement()), present) : present;
}

void AnchorSurveyDialog::update()
{
    const bool good = isPlaced();
    for (QWidget* control : std::initializer_list<QWidget*>{m_frame, m_flip, m_rotation})
        control->setEnabled(good);
    const std::vector<UwbAnchor> proposed = proposal();
    m_view->setAnchors(m_editor.anchors(), good ? proposed : std::vector<UwbAnchor>());
    m_accept->setEnabled(good && proposed != m_editor.anchors());
    m_again->setEnabled(m_survey.has_value());
    showNotes();
}

void AnchorSurveyDialog::showNotes()
{
    Glyph glyph = Glyph::Info;
    QStringList lines;
    if (!m_survey) {
        lines << tr("Computing the places…");
    } else if (!isPlaced()) {
        glyph = Glyph::Error;
        lines << (m_survey->trouble.empty() ? tr("The anchors do not range each other.")
                                            : model::Messages::sentence(m_survey->trouble));
    } else {
        const auto worst = std::ranges::max_element(m_survey->anchors, {}, &SurveyedAnchor::sd_m);
        lines << tr("Ranges minus distances: %1 (root mean square). Least certain place: ±%2.")
                     .arg(Words::millimetres(m_survey->residual_m), Words::millimetres(worst->sd_m));
        if (!m_survey->notes.empty())
            glyph = Glyph::Warning;
        for (const std::string& note : m_survey->notes)
            lines << model::Messages::sentence(note);
    }
    m_status->setText(lines.join(QLatin1Char('\n')));
    showStatusGlyph(*m_icon, glyph, m_theme);
}

void AnchorSurveyDialog::accept()
{
    if (!m_accept->isEnabled())
        return;
    m_editor.setAnchors(tr("Place anchors"), proposal());
    QDialog::accept();
}

} // namespace agv::gui
