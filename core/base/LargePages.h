// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

namespace core {

/// Asks the system for large pages, where it has them, below memory that is about to be written for
/// the first time: sixty thousand page faults of a volume become a hundred. Changes nothing else.
void useLargePages(void* memory, std::size_t bytes);

/// An empty vector to so many zeros, in large pages.
template <class Value> void resizeInLargePages(std::vector<Value>& values, std::size_t count)
{
    values.reserve(count);
    useLargePages(values.data(), count * sizeof(Value));
    values.resize(count);
}

} // namespace core
