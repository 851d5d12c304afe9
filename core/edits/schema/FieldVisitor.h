// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/schema/SchemaParts.h"

#include <optional>

namespace core::editSchema {

/// The base of visitors of an edit's fields (SchemaParts.h). By default it visits each given value
/// as a field, enters each group and each condition that holds, and skips constants. A derived
/// class provides field() and overrides what it treats differently.
template <class Visitor> class FieldVisitor {
public:
    template <class Kind>
    void maybe(const char* name, std::optional<typename Kind::Value>& value, const Kind& kind,
        const char* meaning, const char* = nullptr)
    {
        if (value)
            self().field(name, Presence::Optional, *value, kind, meaning);
    }
    void constant(const char*, Presence, const QJsonValue&, const char*) { }
    template <class Inside> void group(const char*, const char*, const Inside& visitInside)
    {
        visitInside(self());
    }
    template <class Value, class Inside>
    void maybeGroup(const char* name, std::optional<Value>& value, const char* meaning, const char*,
        const Inside& visitInside)
    {
        if (value)
            self().group(name, meaning, [&](Visitor& inside) { visitInside(inside, *value); });
    }
    template <class Inside> void when(bool condition, const Inside& visitInside)
    {
        if (condition)
            visitInside();
    }

private:
    Visitor& self() { return static_cast<Visitor&>(*this); }
};

} // namespace core::editSchema
