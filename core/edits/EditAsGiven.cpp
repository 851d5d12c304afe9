// SPDX-License-Identifier: Apache-2.0
#include "core/edits/EditAsGiven.h"

#include "core/edits/kinds/AnyEdit.h"
#include "core/edits/kinds/FieldRoles.h"
#include "core/edits/schema/FieldVisitor.h"

#include <optional>

namespace core {

using editSchema::Presence;

namespace {

/// Leaves out what was found.
class FoundRemover : public editSchema::FieldVisitor<FoundRemover> {
public:
    template <class Kind>
    void field(const char*, Presence, typename Kind::Value&, const Kind&, const char*)
    {
        static_assert(fieldRole<Kind>() != FieldRole::Found,
            "what is found is absent at first: such a field is shown by maybe()");
    }
    template <class Kind>
    void maybe(const char*, std::optional<typename Kind::Value>& value, const Kind&, const char*,
        const char* = nullptr)
    {
        if constexpr (fieldRole<Kind>() == FieldRole::Found)
            value.reset();
    }
};

} // namespace

Edit asFirstGiven(Edit edit)
{
    FoundRemover remover;
    visitEdit([&remover](auto& known) { editSchema::visitFields(remover, known); }, edit);
    return edit;
}

} // namespace core
