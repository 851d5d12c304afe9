// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <QJsonObject>

namespace ui {

/// What the user chooses for contours that evolve (ContourTool), kept with a session.
struct ContourSettings {
    /// Bubbles: as Bubble, and a click adds one more to the contour that is open.
    enum class Start { Bubble, Bubbles, Segment, Seeds };

    Start start = Start::Bubble; ///< with what the contour begins
    double bubbleMm = 4.0; ///< radius of all bubbles
    /// A pen that is pressed less makes those of its contour smaller; else its pressure does
    /// nothing.
    bool radiusByPressure = false;
    /// Bubbles set the interval to the one suggested for their centres.
    bool valuesOfBubble = true;
    int softness = 25; ///< per cent of half the interval's width, 0 … 100
    int smoothness = 50; ///< 0 … 100; so is edge
    int edge = 0;
    double edgeGradient = 0.0; ///< modality units per mm; 0: not chosen
    int generations = 100; ///< greatest number
    bool operator==(const ContourSettings&) const = default;

    static constexpr double minimumBubbleMm = 0.5;
    static constexpr double maximumBubbleMm = 100.0;
    static constexpr double maximumGradient = 1e6;

    /// Whether it begins where one clicks.
    [[nodiscard]] bool startsFromBubbles() const
    {
        return start == Start::Bubble || start == Start::Bubbles;
    }
    /// Makes bubbles greater by so many steps of the wheel, or smaller.
    void changeBubble(int steps);
    [[nodiscard]] QJsonObject json() const;
    /// Takes what is there and within its bounds; the rest stays.
    void read(const QJsonObject& json);
};

} // namespace ui
