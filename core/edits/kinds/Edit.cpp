// SPDX-License-Identifier: Apache-2.0
#include "core/edits/kinds/Edit.h"

#include "core/edits/kinds/AnyEdit.h"

#include <array>

namespace core {

namespace {

template <class E> std::unique_ptr<EditVariant> madeOf(void* edit)
{
    return std::make_unique<EditVariant>(std::in_place_type<E>, std::move(*static_cast<E*>(edit)));
}

template <class... Es>
std::unique_ptr<EditVariant> madeOfKind(std::size_t place, void* edit, EditKinds<Es...>)
{
    constexpr std::array makers{&madeOf<Es>...};
    return makers.at(place)(edit);
}

} // namespace

Edit::Edit()
    : m_edit(std::make_unique<EditVariant>())
{
}

Edit::Edit(std::size_t place, void* edit)
    : m_edit(madeOfKind(place, edit, AllEdits()))
{
}

Edit::Edit(const Edit& other)
    : m_edit(other.m_edit ? std::make_unique<EditVariant>(*other.m_edit) : nullptr)
{
}

Edit::Edit(Edit&& other) noexcept = default;

Edit& Edit::operator=(const Edit& other)
{
    return *this = Edit(other);
}

Edit& Edit::operator=(Edit&& other) noexcept = default;

Edit::~Edit() = default;

std::size_t Edit::kind() const
{
    return m_edit->index();
}

const void* Edit::find(std::size_t place) const
{
    if (!m_edit || m_edit->index() != place)
        return nullptr;
    return std::visit([](const auto& known) -> const void* { return &known; }, *m_edit);
}

const void* Edit::demand(std::size_t place) const
{
    const void* edit = find(place);
    if (!edit)
        throw std::bad_variant_access();
    return edit;
}

} // namespace core
