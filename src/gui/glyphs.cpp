// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/glyphs.h"

#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>

namespace agv::gui {
namespace {

QPainterPath polyline(std::initializer_list<QPointF> points, bool closed = false)
{
    QPainterPath path;
    path.addPolygon(QPolygonF(points));
    if (closed)
        path.closeSubpath();
    return path;
}

QPainterPath circle(QPointF centre, double radius)
{
    QPainterPath path;
    path.addEllipse(centre, radius, radius);
    return path;
}

QPainterPath arc(QPointF centre, double radius, double from_deg, double span_deg)
{
    const QRectF box(centre - QPointF(radius, radius), QSizeF(2 * radius, 2 * radius));
    QPainterPath path;
    path.arcMoveTo(box, from_deg);
    path.arcTo(box, from_deg, span_deg);
    return path;
}

QPainterPath rectangle(double x, double y, double w, double h, double corner = 1.5)
{
    QPainterPath path;
    path.addRoundedRect(QRectF(x, y, w, h), corner, corner);
    return path;
}

QPainterPath lens()
{
    QPainterPath path = circle({10.5, 10.5}, 6.5);
    path.addPath(polyline({{15.3, 15.3}, {20.5, 20.5}}));
    return path;
}

struct Shape {
    QPainterPath stroke;
    QPainterPath fill;
    QPainterPath cut; ///< painted over `fill` in the background's stead
};

Shape toolShape(Glyph glyph)
{
    Shape s;
    switch (glyph) {
    case Glyph::Stop:
        s.fill = polyline(
            {{8, 2.5}, {16, 2.5}, {21.5, 8}, {21.5, 16}, {16, 21.5}, {8, 21.5}, {2.5, 16}, {2.5, 8}}, true);
        s.cut = rectangle(8, 8, 8, 8, 1.0);
        break;
    case Glyph::Fit:
        for (const auto& corner :
             {polyline({{3.5, 9}, {3.5, 3.5}, {9, 3.5}}), polyline({{15, 3.5}, {20.5, 3.5}, {20.5, 9}}),
              polyline({{20.5, 15}, {20.5, 20.5}, {15, 20.5}}),
              polyline({{9, 20.5}, {3.5, 20.5}, {3.5, 15}})})
            s.stroke.addPath(corner);
        s.fill = circle({12, 12}, 2.6);
        break;
    case Glyph::Target:
        s.stroke = circle({12, 12}, 6);
        for (const auto& tick : {polyline({{12, 2}, {12, 6}}), polyline({{12, 18}, {12, 22}}),
                                 polyline({{2, 12}, {6, 12}}), polyline({{18, 12}, {22, 12}})})
            s.stroke.addPath(tick);
        s.fill = circle({12, 12}, 1.8);
        break;
    case Glyph::ZoomIn:
        s.stroke = lens();
        s.stroke.addPath(polyline({{10.5, 7.5}, {10.5, 13.5}}));
        s.stroke.addPath(polyline({{7.5, 10.5}, {13.5, 10.5}}));
        break;
    case Glyph::ZoomOut:
        s.stroke = lens();
        s.stroke.addPath(polyline({{7.5, 10.5}, {13.5, 10.5}}));
        break;
    case Glyph::ZoomTo:
        s.stroke = lens();
        s.fill = circle({10.5, 10.5}, 2.6);
        break;
    case Glyph::Turn:
        s.stroke = arc({12, 12}, 8, -60, 300);
        s.fill = polyline({{16.8, 21.8}, {20.2, 14.6}, {12.8, 16.6}}, true);
        break;
    case Glyph::Abort:
        s.stroke = polyline({{5, 5}, {19, 19}});
        s.stroke.addPath(polyline({{19, 5}, {5, 19}}));
        break;
    case Glyph::Copy:
        s.stroke = rectangle(8.5, 8.5, 12, 12);
        s.stroke.addPath(polyline({{5, 15.5}, {3.5, 15.5}, {3.5, 3.5}, {15.5, 3.5}, {15.5, 5}}));
        break;
    case Glyph::Retake:
        s.stroke = arc({12, 12.5}, 7.5, 60, 290);
        s.fill = polyline({{11.5, 1.5}, {18.5, 5.5}, {11.8, 9.5}}, true);
        break;
    case Glyph::Plug:
        s.stroke = polyline({{12, 16.5}, {12, 21.5}});
        s.stroke.addPath(polyline({{8.5, 2.5}, {8.5, 8}}));
        s.stroke.addPath(polyline({{15.5, 2.5}, {15.5, 8}}));
        s.fill = rectangle(5.5, 8, 13, 8.5, 3.5);
        break;
    case Glyph::Unplug:
        s.stroke = polyline({{3.5, 3.5}, {20.5, 20.5}});
        s.stroke.addPath(polyline({{12, 17}, {12, 21.5}}));
        s.stroke.addPath(polyline({{8.5, 2.5}, {8.5, 5}}));
        s.stroke.addPath(polyline({{15.5, 2.5}, {15.5, 8}, {18.5, 8}, {18.5, 12.5}}));
        s.stroke.addPath(polyline({{5.5, 9}, {5.5, 13}, {8.5, 16.5}, {13.5, 16.5}}));
        break;
    default:
        break;
    }
    return s;
}

Shape stateShape(Glyph glyph)
{
    Shape s;
    switch (glyph) {
    case Glyph::Check:
        s.stroke = circle({12, 12}, 9);
        s.stroke.addPath(polyline({{7.5, 12.5}, {10.8, 15.8}, {16.8, 8.8}}));
        break;
    case Glyph::Warning:
    case Glyph::LinkSilent:
        s.fill = polyline({{12, 2.5}, {22.5, 21}, {1.5, 21}}, true);
        s.cut = rectangle(10.9, 9, 2.2, 6, 1.0);
        s.cut.addPath(circle({12, 17.8}, 1.35));
        break;
    case Glyph::Error:
    case Glyph::LinkFailed:
        s.fill = rectangle(3, 3, 18, 18, 3.0);
        s.cut = polyline({{7.2, 8.6},
                          {8.6, 7.2},
                          {12, 10.6},
                          {15.4, 7.2},
                          {16.8, 8.6},
                          {13.4, 12},
                          {16.8, 15.4},
                          {15.4, 16.8},
                          {12, 13.4},
                          {8.6, 16.8},
                          {7.2, 15.4},
                          {10.6, 12}},
                         true);
        break;
    case Glyph::Info:
        s.stroke = circle({12, 12}, 9);
        s.fill = circle({12, 7.6}, 1.4);
        s.fill.addPath(rectangle(10.9, 10.6, 2.2, 7, 1.0));
        break;
    case Glyph::LinkUp:
        s.fill = circle({12, 12}, 7);
        break;
    case Glyph::LinkDown:
        s.stroke = circle({12, 12}, 6.5);
        break;
    case Glyph::LinkOpening:
        s.stroke = circle({12, 12}, 6.5);
        s.fill = polyline({{12, 12}, {12, 5.5}}, false);
        s.fill.arcTo(QRectF(5.5, 5.5, 13, 13), 90, -180);
        s.fill.closeSubpath();
        break;
    case Glyph::LinkWaiting:
        s.stroke = polyline({{6.5, 4}, {17.5, 4}, {12, 12}, {17.5, 20}, {6.5, 20}, {12, 12}}, true);
        break;
    default:
        break;
    }
    return s;
}

class GlyphEngine : public QIconEngine {
public:
    GlyphEngine(Glyph glyph, QColor colour, QColor disabled)
        : m_glyph(glyph),
          m_colour(colour),
          m_disabled(disabled)
    {}
    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        paintGlyph(*painter, rect, m_glyph, mode == QIcon::Disabled ? m_disabled : m_colour);
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(), size), mode, state);
        return pixmap;
    }
    QIconEngine* clone() const override { return new GlyphEngine(*this); }

private:
    Glyph m_glyph;
    QColor m_colour;
    QColor m_disabled;
};

} // namespace

void paintGlyph(QPainter& painter, const QRectF& where, Glyph glyph, const QColor& colour)
{
    Shape shape = toolShape(glyph);
    if (shape.stroke.isEmpty() && shape.fill.isEmpty())
        shape = stateShape(glyph);
    const double side = std::min(where.width(), where.height());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(where.center() - QPointF(0.5 * side, 0.5 * side));
    painter.scale(side / 24.0, side / 24.0);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colour);
    painter.drawPath(shape.fill.subtracted(shape.cut));
    painter.setPen(QPen(colour, 2.0, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(shape.stroke);
    painter.restore();
}

QIcon glyphIcon(Glyph glyph, const QColor& colour, const QColor& disabled)
{
    return QIcon(new GlyphEngine(glyph, colour, disabled));
}

Glyph glyphOf(LinkState state)
{
    switch (state) {
    case LinkState::Down:
        return Glyph::LinkDown;
    case LinkState::Opening:
        return Glyph::LinkOpening;
    case LinkState::Up:
        return Glyph::LinkUp;
    case LinkState::Silent:
        return Glyph::LinkSilent;
    case LinkState::Waiting:
        return Glyph::LinkWaiting;
    case LinkState::Failed:
        return Glyph::LinkFailed;
    }
    return Glyph::LinkDown;
}

Glyph glyphOf(AlarmPriority priority)
{
    switch (priority) {
    case AlarmPriority::High:
        return Glyph::Error;
    case AlarmPriority::Medium:
        return Glyph::Warning;
    case AlarmPriority::Low:
        break;
    }
    return Glyph::Info;
}

Glyph glyphOf(EventLevel level)
{
    switch (level) {
    case EventLevel::Detail:
        return Glyph::LinkDown;
    case EventLevel::Info:
        return Glyph::Info;
    case EventLevel::Warning:
        return Glyph::Warning;
    case EventLevel::Error:
        return Glyph::Error;
    }
    return Glyph::Info;
}

QIcon applicationIcon()
{
    QIcon icon;
    for (int side : {16, 24, 32, 48, 64, 128, 256}) {
        QPixmap pixmap(side, side);
        pixmap.fill(Qt::transparent);
        QPainter p(&pixmap);
        p.setRenderHint(QPainter::Antialiasing);
        p.scale(side / 64.0, side / 64.0);
        p.setPen(Qt::NoPen);
        p.setBrush(QColor(0x1c2a38));
        p.drawRoundedRect(QRectF(2, 2, 60, 60), 13, 13);
        p.setBrush(QColor(0x5b7186));
        for (int x = 0; x < 4; ++x) {
            for (int y = 0; y < 4; ++y)
                p.drawEllipse(QPointF(11 + 14 * x, 11 + 14 * y), 2.0, 2.0);
        }
        p.setBrush(QColor(0xe9eef3));
        p.drawEllipse(QPointF(32, 32), 17, 17);
        p.setBrush(QColor(0x2b6390));
        p.drawPolygon(QPolygonF{{32, 18.5}, {41, 39}, {32, 34.5}, {23, 39}});
        p.end();
        icon.addPixmap(pixmap);
    }
    return icon;
}

} // namespace agv::gui
