// SPDX-License-Identifier: GPL-3.0-or-later
#include "gui/uwb_editor.h"

#include "model/anchor_table_model.h"
#include "model/cell_input.h"
#include "model/uwb_tag_table_model.h"

#include <QUndoCommand>

#include <algorithm>
#include <optional>
#include <utility>

namespace agv::gui {
namespace {

/// What `id` is called after the edit: itself, its new number when only that changed, or nothing when it is
/// gone.
template<typename Item>
std::optional<int> idAfter(int id, const std::vector<Item>& before, const std::vector<Item>& after)
{
    if (std::ranges::find(after, id, &Item::id) != after.end())
        return id;
    const auto place = std::ranges::find(before, id, &Item::id);
    if (place == before.end() || before.size() != after.size())
        return std::nullopt;
    return after[static_cast<std::size_t>(place - before.begin())].id;
}

template<typename Item>
std::vector<RangeCorrection> followed(const std::vector<RangeCorrection>& corrections,
                                      int RangeCorrection::* member, const std::vector<Item>& before,
                                      const std::vector<Item>& after)
{
    std::vector<RangeCorrection> kept;
    for (RangeCorrection correction : corrections) {
        const bool known = std::ranges::find(before, correction.*member, &Item::id) != before.end();
        const std::optional<int> id = known ? idAfter(correction.*member, before, after) : correction.*member;
        if (!id)
            continue;
        correction.*member = *id;
        kept.push_back(correction);
    }
    return kept;
}

template<typename Item>
std::optional<int> lowestFreeId(const std::vector<Item>& items)
{
    for (int id = 0; id <= model::mostUwbNumber; ++id) {
        if (std::ranges::find(items, id, &Item::id) == items.end())
            return id;
    }
    return std::nullopt;
}

template<typename Item>
std::vector<Item> without(std::vector<Item> items, const std::vector<int>& ids)
{
    std::erase_if(items, [&ids](const Item& item) { return std::ranges::find(ids, item.id) != ids.end(); });
    return items;
}

/// "A0, A1" of those that are removed.
template<typename Item, typename Name>
QString namesOf(const std::vector<Item>& items, const std::vector<int>& ids, const Name& name)
{
    QStringList names;
    for (const Item& item : items) {
        if (std::ranges::find(ids, item.id) != ids.end())
            names << name(item);
    }
    return names.join(QStringLiteral(", "));
}

} // namespace

class UwbEditor::Entry : public QUndoCommand {
public:
    Entry(UwbEditor& editor, const QString& what, Kit after)
        : QUndoCommand(what),
          m_editor(editor),
          m_before(editor.kit()),
          m_after(std::move(after))
    {}
    void undo() override { m_editor.apply(m_before); }
    void redo() override { m_editor.apply(m_after); }

private:
    UwbEditor& m_editor;
    Kit m_before;
    Kit m_after;
};

UwbEditor::UwbEditor(QObject* parent) : QObject(parent)
{
    connect(&m_undo, &QUndoStack::cleanChanged, this, [this](bool clean) { emit unsavedChanged(!clean); });
}

void UwbEditor::setKit(Kit kit)
{
    m_undo.clear();
    m_kit = std::move(kit);
}

void UwbEditor::apply(const Kit& kit)
{
    m_kit = kit;
    emit edited(m_kit.anchors, m_kit.settings);
}

void UwbEditor::edit(const QString& what, Kit kit)
{
    if (kit != m_kit)
        m_undo.push(new Entry(*this, what, std::move(kit)));
}

void UwbEditor::setAnchors(const QString& what, const std::vector<UwbAnchor>& anchors)
{
    Kit kit = m_kit;
    kit.settings.corrections =
        followed(m_kit.settings.corrections, &RangeCorrection::anchor, m_kit.anchors, anchors);
    kit.anchors = anchors;
    edit(what, std::move(kit));
}

void UwbEditor::setTags(const QString& what, const std::vector<UwbTag>& tags)
{
    Kit kit = m_kit;
    kit.settings.corrections =
        followed(m_kit.settings.corrections, &RangeCorrection::tag, m_kit.settings.tags, tags);
    kit.settings.tags = tags;
    edit(what, std::move(kit));
}

void UwbEditor::setCorrections(const QString& what, const std::vector<RangeCorrection>& corrections)
{
    Kit kit = m_kit;
    kit.settings.corrections = corrections;
    edit(what, std::move(kit));
}

void UwbEditor::setPort(const SerialPortChoice& port, std::optional<UwbDialect> dialect)
{
    Kit kit = m_kit;
    kit.settings.port = port;
    kit.settings.dialect = dialect;
    edit(tr("Choose port %1").arg(QString::fromStdString(toText(port))), std::move(kit));
}

bool UwbEditor::addAnchor()
{
    const std::optional<int> id = lowestFreeId(m_kit.anchors);
    if (!id)
        return false;
    UwbAnchor anchor;
    anchor.id = *id;
    anchor.label = "A" + std::to_string(*id); // as the plant file would
    anchor.z = m_kit.anchors.empty() ? 0.0 : m_kit.anchors.back().z;
    std::vector<UwbAnchor> anchors = m_kit.anchors;
    anchors.push_back(anchor);
    setAnchors(tr("Add %1").arg(model::anchorName(anchor)), anchors);
    return true;
}

bool UwbEditor::addTag()
{
    const std::optional<int> id = lowestFreeId(m_kit.settings.tags);
    if (!id)
        return false;
    UwbTag tag;
    tag.id = *id;
    tag.label = "T" + std::to_string(*id);
    tag.z_m = m_kit.settings.tagHeight_m;
    std::vector<UwbTag> tags = m_kit.settings.tags;
    tags.push_back(tag);
    setTags(tr("Add %1").arg(model::uwbTagName(tag)), tags);
    return true;
}

void UwbEditor::removeAnchors(const std::vector<int>& ids)
{
    setAnchors(tr("Remove %1").arg(namesOf(m_kit.anchors, ids, model::anchorName)),
               without(m_kit.anchors, ids));
}

void UwbEditor::removeTags(const std::vector<int>& ids)
{
    setTags(tr("Remove %1").arg(namesOf(m_kit.settings.tags, ids, model::uwbTagName)),
            without(m_kit.settings.tags, ids));
}

} // namespace agv::gui
