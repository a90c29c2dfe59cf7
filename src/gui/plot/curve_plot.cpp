// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/plot/curve_plot.h"

#include "gui/plot/axis_style.h"

#include <qcustomplot.h>

#include <algorithm>
#include <cmath>

namespace agv::gui {
namespace {

// Okabe and Ito's set, chosen so that people with any of the usual kinds of colour blindness tell them apart;
// darker for a light ground, lighter for a dark one.
constexpr QRgb curveColours[2][5] = {{0x0072b2, 0xd55e00, 0x00805e, 0xa8578a, 0x6b6b6b},
                                     {0x56b4e9, 0xe69f00, 0x2fc99b, 0xdd96bf, 0xb8b8b8}};

QPen curvePen(int curve, bool dark)
{
    QPen pen(QColor::fromRgb(curveColours[dark ? 1 : 0][curve % 5]), 1.0);
    pen.setStyle((curve / 5) % 2 == 0 ? Qt::SolidLine : Qt::DashLine);
    return pen;
}

} // namespace

class CurvePlot::Private {
public:
    QCustomPlot* plot = nullptr;
    QCPItemLine* cursor = nullptr;
    QLabel* hintLabel = nullptr;
    std::vector<QCPAbstractItem*> marks;
    std::vector<std::pair<double, QString>> markTexts;
    qsizetype mostInLegend = 12;
    Theme theme = Theme::light();
};

CurvePlot::CurvePlot(QWidget* parent) : QWidget(parent), d(std::make_unique<Private>())
{
    d->plot = new QCustomPlot(this);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(d->plot);
    d->plot->setNotAntialiasedElements(QCP::aeAll);
    d->plot->setNoAntialiasingOnDrag(true);
    d->plot->setPlottingHint(QCP::phFastPolylines, true);
    d->plot->legend->setVisible(true);
    d->plot->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignLeft);
    d->cursor = new QCPItemLine(d->plot);
    d->cursor->setVisible(false);
    d->hintLabel = new QLabel(d->plot);
    d->hintLabel->setAlignment(Qt::AlignCenter);
    d->hintLabel->setWordWrap(true);
    d->hintLabel->setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* overlay = new QVBoxLayout(d->plot);
    overlay->setContentsMargins(70, 20, 30, 50);
    overlay->addWidget(d->hintLabel);
    connectPlot();
}

CurvePlot::~CurvePlot() = default;

void CurvePlot::connectPlot()
{
    d->plot->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    d->plot->axisRect()->setRangeDrag(Qt::Horizontal);
    d->plot->axisRect()->setRangeZoom(Qt::Horizontal);
    const auto chosen = [this] { emit xRangeChosen(xFrom(), xTo()); };
    // After QCustomPlot has moved its axis.
    connect(d->plot, &QCustomPlot::mouseWheel, this, chosen, Qt::QueuedConnection);
    connect(d->plot, &QCustomPlot::mouseMove, this, [this, chosen](const QMouseEvent* event) {
        if (event->buttons() & Qt::LeftButton)
            QMetaObject::invokeMethod(this, chosen, Qt::QueuedConnection);
        const double x = d->plot->xAxis->pixelToCoord(event->position().x());
        const bool inside = d->plot->axisRect()->rect().contains(event->position().toPoint());
        d->cursor->setVisible(inside);
        d->cursor->start->setCoords(x, d->plot->yAxis->range().lower);
        d->cursor->end->setCoords(x, d->plot->yAxis->range().upper);
        d->plot->replot(QCustomPlot::rpQueuedReplot);
        emit cursorMoved(inside ? std::optional(x) : std::nullopt);
    });
}

void CurvePlot::leaveEvent(QEvent*)
{
    d->cursor->setVisible(false);
    d->plot->replot(QCustomPlot::rpQueuedReplot);
    emit cursorMoved(std::nullopt);
}

void CurvePlot::setTheme(const Theme& theme)
{
    d->theme = theme;
    d->plot->setBackground(theme.panel);
    d->plot->axisRect()->setBackground(theme.sunken);
    QColor ground = theme.panel;
    ground.setAlpha(210);
    d->plot->legend->setBrush(ground);
    d->plot->legend->setBorderPen(Qt::NoPen);
    d->plot->legend->setTextColor(theme.text);
    d->plot->legend->setFont(font());
    for (QCPAxis* axis : {d->plot->xAxis, d->plot->yAxis})
        styleAxis(*axis, theme, font());
    d->cursor->setPen(QPen(theme.text, 1.0, Qt::DotLine));
    QPalette palette = d->hintLabel->palette();
    palette.setColor(QPalette::WindowText, theme.mutedText);
    d->hintLabel->setPalette(palette);
    styleCurves();
    setMarks(d->markTexts);
    replot();
}

void CurvePlot::styleCurves()
{
    for (int i = 0; i < d->plot->graphCount(); ++i)
        d->plot->graph(i)->setPen(curvePen(i, d->theme.dark));
}

void CurvePlot::setAxisTitles(const QString& x, const QString& y)
{
    d->plot->xAxis->setLabel(x);
    d->plot->yAxis->setLabel(y);
    setAccessibleName(y + QStringLiteral(" / ") + x);
}

void CurvePlot::setCurves(const QStringList& names)
{
    while (d->plot->graphCount() > names.size())
        d->plot->removeGraph(d->plot->graphCount() - 1);
    while (d->plot->graphCount() < names.size()) {
        QCPGraph* graph = d->plot->addGraph();
        graph->setAdaptiveSampling(false); // the points are chosen before
    }
    for (int i = 0; i < names.size(); ++i)
        d->plot->graph(i)->setName(names[i]);
    d->plot->legend->setVisible(names.size() > 0 && names.size() <= d->mostInLegend);
    styleCurves();
}

void CurvePlot::setPoints(int curve, const std::vector<model::SeriesPoint>& points)
{
    QVector<QCPGraphData> shown;
    shown.reserve(static_cast<qsizetype>(points.size()));
    for (const model::SeriesPoint& point : points)
        shown.append({point.t, point.value});
    d->plot->graph(curve)->data()->set(shown, true);
}

void CurvePlot::setMarks(const std::vector<std::pair<double, QString>>& marks)
{
    for (QCPAbstractItem* item : d->marks)
        d->plot->removeItem(item);
    d->marks.clear();
    d->markTexts = marks;
    for (const auto& [x, text] : marks) {
        auto* line = new QCPItemStraightLine(d->plot);
        line->point1->setCoords(x, 0.0);
        line->point2->setCoords(x, 1.0);
        line->setPen(QPen(d->theme.mutedText, 1.0, Qt::DashLine));
        auto* label = new QCPItemText(d->plot);
        label->position->setTypeX(QCPItemPosition::ptPlotCoords);
        label->position->setTypeY(QCPItemPosition::ptAxisRectRatio);
        // One below the other, so that near ones stay readable.
        label->position->setCoords(x, 0.30 + 0.14 * static_cast<double>(d->marks.size() / 2));
        label->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
        label->setText(QLatin1Char(' ') + text);
        label->setColor(d->theme.text);
        label->setFont(font());
        d->marks.insert(d->marks.end(), {line, label});
    }
}

void CurvePlot::keepLegendSmall()
{
    d->mostInLegend = 3;
    d->plot->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignBottom | Qt::AlignRight);
}

void CurvePlot::setXRange(double from, double to)
{
    d->plot->xAxis->setRange(from, std::max(to, from + 1e-9));
}

double CurvePlot::xFrom() const { return d->plot->xAxis->range().lower; }
double CurvePlot::xTo() const { return d->plot->xAxis->range().upper; }

void CurvePlot::fitY(bool fromZero)
{
    double low = 0.0;
    double high = 0.0;
    bool any = false;
    for (int i = 0; i < d->plot->graphCount(); ++i) {
        for (const QCPGraphData& point : *d->plot->graph(i)->data()) {
            low = any ? std::min(low, point.value) : point.value;
            high = any ? std::max(high, point.value) : point.value;
            any = true;
        }
    }
    d->hintLabel->setVisible(!any);
    if (!any)
        return d->plot->yAxis->setRange(0.0, 1.0);
    if (fromZero)
        low = std::min(low, 0.0);
    const double room = std::max(0.06 * (high - low), 1e-3 * std::max(std::abs(high), 1.0));
    d->plot->yAxis->setRange(fromZero && low == 0.0 ? 0.0 : low - room, high + room);
}

void CurvePlot::replot() { d->plot->replot(QCustomPlot::rpQueuedReplot); }

int CurvePlot::plotWidth() const { return std::max(100, d->plot->axisRect()->width()); }

void CurvePlot::setHint(const QString& hint) { d->hintLabel->setText(hint); }

void CurvePlot::paint(QPainter& painter, QSize size) const
{
    QCPPainter inner;
    QPicture picture;
    inner.begin(&picture);
    inner.setMode(QCPPainter::pmVectorized);
    d->plot->toPainter(&inner, size.width(), size.height());
    inner.end();
    painter.drawPicture(0, 0, picture);
}

} // namespace agv::gui
