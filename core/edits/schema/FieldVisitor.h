// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/schema/SchemaParts.h"

#include <optional>

namespace core::editSchema {

/// The base of visitors of an edit's fields (SchemaParts.h). It takes each value that is there as a
/// field, enters each object and each condition that is there, and skips constants. What derives
/// from it has field(), and its own form of what it treats otherwise.
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
