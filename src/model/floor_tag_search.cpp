// SPDX-License-Identifier: GPL-3.0-or-later
#include "model/floor_tag_search.h"

namespace agv::model {

std::vector<const FloorTag*> floorTagsNamed(const QString& text, const PlantLayout& plant)
{
    const std::string wanted = text.trimmed().toUpper().toStdString();
    std::vector<const FloorTag*> byNumber;
    std::vector<const FloorTag*> byId;
    for (const FloorTag& tag : plant.floorTags) {
        if (std::to_string(tag.number) == wanted)
            byNumber.push_back(&tag);
        if (!wanted.empty() && fullText(tag.uid).ends_with(wanted))
            byId.push_back(&tag);
    }
    return byNumber.empty() ? byId : byNumber;
}

} // namespace agv::model
