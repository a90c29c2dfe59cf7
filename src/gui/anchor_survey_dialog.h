// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "core/anchor_survey.h"
#include "gui/theme.h"
#include "model/survey_placement.h"

#include <optional>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace agv::gui {

class AnchorSurveyView;
class UwbEditor;

/// Places the anchors by the ranges between them: shows what the survey proposes, lets the operator lay it
/// into the plant, and moves the anchors as one edit when he accepts.
class AnchorSurveyDialog : public QDialog {
    Q_OBJECT
public:
    explicit AnchorSurveyDialog(UwbEditor& editor, QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    void showSurvey(const AnchorSurvey& survey);
    /// The list with the anchors at their proposed places.
    std::vector<UwbAnchor> proposal() const;

signals:
    void surveyRequested();

private:
    void buildControls();
    void accept() override;
    void fillOrigins();
    void update();
    void showNotes();
    model::SurveyPlacement placement() const;
    bool isPlaced() const { return m_survey && m_survey->trouble.empty() && !m_survey->anchors.empty(); }

    UwbEditor& m_editor;
    std::optional<AnchorSurvey> m_survey; ///< empty: not answered yet
    Theme m_theme = Theme::light();
    AnchorSurveyView* m_view;
    QComboBox* m_frame;
    QCheckBox* m_flip;
    QDoubleSpinBox* m_rotation;
    QLabel* m_icon;
    QLabel* m_status;
    QPushButton* m_again;
    QPushButton* m_accept;
    QPushButton* m_discard;
};

} // namespace agv::gui
