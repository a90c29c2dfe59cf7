// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/json_tree.h"

#include <functional>
#include <string>

namespace agv {

/// What makes two elements of a list the same thing: "1" for {"id": 1}. Empty: nothing does.
using IdentityOf = std::function<std::string(const Json& element)>;

/// An element with every value at its default, for the element `fresh` at `index`.
using DefaultsOf = std::function<Json(const Json& fresh, std::size_t index)>;

/// `fresh` in the shape of `original`: its order of keys, its members that `fresh` does not have, and
/// without the members that it left out and that still have their default.
Json mergedObject(const Json& original, const Json& fresh, const Json& defaults);

/// `fresh` element by element in the shape of the same element of `original`: the one with the same
/// identity, else the one at the same place when it has no other partner.
Json mergedList(const Json& original, const Json& fresh, const IdentityOf& identityOf,
                const DefaultsOf& defaultsOf);

} // namespace agv
