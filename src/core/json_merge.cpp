// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/json_merge.h"

#include <optional>
#include <unordered_map>
#include <vector>

namespace agv {
namespace {

const Json* memberOf(const Json& object, const std::string& key)
{
    const auto found = object.is_object() ? object.find(key) : object.end();
    return found == object.end() ? nullptr : &*found;
}

/// For each fresh element the index of its original.
std::vector<std::optional<std::size_t>> partners(const Json& original, const Json& fresh,
                                                 const IdentityOf& identityOf)
{
    std::unordered_map<std::string, std::size_t> byIdentity;
    for (std::size_t i = 0; i < original.size(); ++i) {
        if (const std::string identity = identityOf(original[i]); !identity.empty())
            byIdentity.emplace(identity, i);
    }
    std::vector<bool> isTaken(original.size(), false);
    std::vector<std::optional<std::size_t>> found(fresh.size());
    for (std::size_t i = 0; i < fresh.size(); ++i) {
        const auto same = byIdentity.find(identityOf(fresh[i]));
        if (same != byIdentity.end() && !isTaken[same->second]) {
            found[i] = same->second;
            isTaken[same->second] = true;
        }
    }
    for (std::size_t i = 0; i < fresh.size() && i < original.size(); ++i) {
        if (!found[i] && !isTaken[i])
            found[i] = i;
    }
    return found;
}

} // namespace

Json mergedObject(const Json& original, const Json& fresh, const Json& defaults)
{
    Json merged = Json::object();
    // Appended without the search for an equal key: neither tree has one.
    const auto append = [&members = merged.get_ref<Json::object_t&>()](const std::string& key, Json value) {
        members.Container::emplace_back(key, std::move(value));
    };
    for (const auto& [key, value] : original.items()) {
        const Json* const changed = memberOf(fresh, key);
        if (changed == nullptr)
            append(key, value);
        else if (changed->is_object() && value.is_object())
            append(key, mergedObject(value, *changed, defaults.value(key, Json::object())));
        else
            append(key, *changed);
    }
    for (const auto& [key, value] : fresh.items()) {
        const Json* const usual = memberOf(defaults, key);
        if (!original.contains(key) && (usual == nullptr || *usual != value))
            append(key, value);
    }
    return merged;
}

Json mergedList(const Json& original, const Json& fresh, const IdentityOf& identityOf,
                const DefaultsOf& defaultsOf)
{
    const auto partnerOf = partners(original, fresh, identityOf);
    Json merged = Json::array();
    for (std::size_t i = 0; i < fresh.size(); ++i)
        merged.push_back(partnerOf[i]
                             ? mergedObject(original[*partnerOf[i]], fresh[i], defaultsOf(fresh[i], i))
                             : fresh[i]);
    return merged;
}

} // namespace agv
