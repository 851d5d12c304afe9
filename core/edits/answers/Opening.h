// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "core/edits/answers/EditAnswers.h"

#include <concepts>
#include <memory>
#include <type_traits>

namespace core {

struct SurfacePath;

/// Whether an edit can stand open while the engine carries it out.
template <class E>
concept hasOpenStroke = requires(E& edit)
{
    {
        openStroke(edit)
        } -> std::same_as<std::unique_ptr<OpenStroke>>;
};

/// Whether an edit is a tool of the surface, which stands open under the pen and receives further
/// points of its path.
template <class E>
concept isSurfaceTool = std::is_same_v<decltype(E::path), SurfacePath>;

/// Whether an edit is not carried out by the engine alone and stands open otherwise than under a
/// pen.
template <class E>
concept hasOpenManner = requires(const E& edit)
{
    {
        openManner(edit)
        } -> std::same_as<OpenManner>;
};

/// Not defined: an edit X that can stand open says opens<X>() or opensIf<X>(), never `true`.
void mustNameItsKind();

/// Whether an edit can be begun and then continued until it ends: a stroke, a growth that is
/// watched, a preview. Only a kind that declares how it takes further input can be such an edit,
/// which the compiler checks; all others say `false`.
class Opening {
public:
    consteval Opening(bool standsOpen)
    {
        if (standsOpen)
            mustNameItsKind();
    }
    [[nodiscard]] explicit operator bool() const { return m_standsOpen; }

    /// For a kind of edit that can stand open. @p standsOpen says whether this edit can.
    template <class E> [[nodiscard]] static Opening of(bool standsOpen)
    {
        static_assert(hasOpenStroke<E> || isSurfaceTool<E> || hasOpenManner<E>,
            "an edit X that stands open needs std::unique_ptr<OpenStroke> openStroke(X&) or "
            "OpenManner openManner(const X&), or is a tool of the surface");
        Opening opening(false);
        opening.m_standsOpen = standsOpen;
        return opening;
    }

private:
    bool m_standsOpen = false;
};

/// For a kind of which every edit can stand open.
template <class E> [[nodiscard]] Opening opens()
{
    return Opening::of<E>(true);
}
/// For a kind of which only some edits can stand open.
template <class E> [[nodiscard]] Opening opensIf(bool standsOpen)
{
    return Opening::of<E>(standsOpen);
}

} // namespace core
