// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QUndoStack>

#include "core/plant_layout.h"
#include "core/uwb_settings.h"

#include <vector>

namespace agv::gui {

/// The UWB kit of the plant as the operator edits it: anchors, tags, corrections, port. Owns the undo list;
/// every change is one entry of it, and no two entries are merged. Knows nothing of files: the application
/// saves what edited() last said and answers with setSaved(). GUI thread.
class UwbEditor : public QObject {
    Q_OBJECT
public:
    /// What one entry of the undo list takes back.
    struct Kit {
        std::vector<UwbAnchor> anchors;
        UwbSettings settings;
        friend bool operator==(const Kit&, const Kit&) = default;
    };

    explicit UwbEditor(QObject* parent = nullptr);

    /// A plant as it was read: nothing to undo, nothing unsaved.
    void setKit(Kit kit);
    const Kit& kit() const { return m_kit; }
    const std::vector<UwbAnchor>& anchors() const { return m_kit.anchors; }
    const UwbSettings& settings() const { return m_kit.settings; }

    QUndoStack& undoStack() { return m_undo; }
    bool hasUnsavedEdits() const { return !m_undo.isClean(); }
    /// The kit as it is now stands in the plant file.
    void setSaved() { m_undo.setClean(); }

    /// `what` names the edit in the menu: "Move A0". An edit that changes nothing is no edit.
    void edit(const QString& what, Kit kit);
    /// Corrections follow an anchor that gets another number and go with one that is removed.
    void setAnchors(const QString& what, const std::vector<UwbAnchor>& anchors);
    /// The same for tags.
    void setTags(const QString& what, const std::vector<UwbTag>& tags);
    void setCorrections(const QString& what, const std::vector<RangeCorrection>& corrections);
    void setPort(const SerialPortChoice& port, std::optional<UwbDialect> dialect);

    /// With the lowest free number; false when all are in use.
    bool addAnchor();
    bool addTag();
    void removeAnchors(const std::vector<int>& ids);
    void removeTags(const std::vector<int>& ids);

signals:
    /// Also by undo and redo.
    void edited(const std::vector<agv::UwbAnchor>& anchors, const agv::UwbSettings& settings);
    void unsavedChanged(bool unsaved);

private:
    class Entry;
    void apply(const Kit& kit);

    Kit m_kit;
    QUndoStack m_undo;
};

} // namespace agv::gui
