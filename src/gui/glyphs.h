// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QIcon>

#include "core/snapshot.h"

class QPainter;

namespace agv::gui {

/// The program's own icons: strokes and shapes on a 24 x 24 grid, painted at any size and pixel ratio.
enum class Glyph {
    Stop,
    Fit,
    Target,
    ZoomIn,
    ZoomOut,
    ZoomTo,
    Turn,
    Abort,
    Copy,
    Retake,
    Check,
    Warning,
    Error,
    Info,
    Plug,
    Unplug,
    LinkDown,
    LinkOpening,
    LinkUp,
    LinkSilent,
    LinkWaiting,
    LinkFailed,
};

void paintGlyph(QPainter& painter, const QRectF& where, Glyph glyph, const QColor& colour);

/// `disabled` is the colour of the disabled state.
QIcon glyphIcon(Glyph glyph, const QColor& colour, const QColor& disabled);

/// Shape of a link's state: each state has a shape of its own, so that no colour is needed to tell them
/// apart.
Glyph glyphOf(LinkState state);
Glyph glyphOf(EventLevel level);
Glyph glyphOf(AlarmPriority priority);

/// The program's icon.
QIcon applicationIcon();

} // namespace agv::gui
