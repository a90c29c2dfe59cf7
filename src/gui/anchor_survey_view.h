// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/plant_layout.h"
#include "gui/map/viewport.h"
#include "gui/theme.h"

#include <vector>

namespace agv::gui {

/// The present places of anchors, hollow, and the proposed ones, filled, with how far each would move. To
/// scale.
class AnchorSurveyView : public QWidget {
    Q_OBJECT
public:
    explicit AnchorSurveyView(QWidget* parent = nullptr);

    void setTheme(const Theme& theme);
    /// Both in the same order; without a proposal the present places alone are drawn.
    void setAnchors(const std::vector<UwbAnchor>& present, const std::vector<UwbAnchor>& proposed);
    QSize sizeHint() const override { return {420, 300}; }
    QSize minimumSizeHint() const override { return {260, 180}; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    Viewport viewport() const;
    void paintAxes(QPainter& painter, const Viewport& view) const;
    void paintPresent(QPainter& painter, const Viewport& view, const UwbAnchor& anchor) const;
    void paintProposed(QPainter& painter, const Viewport& view, const UwbAnchor& now,
                       const UwbAnchor& then) const;
    void paintName(QPainter& painter, QPointF at, const UwbAnchor& anchor, const QString& second) const;

    std::vector<UwbAnchor> m_present;
    std::vector<UwbAnchor> m_proposed;
    Theme m_theme = Theme::light();
};

} // namespace agv::gui
