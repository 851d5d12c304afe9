// SPDX-License-Identifier: Apache-2.0
#include "gpu/gl/context/CallsDriver.h"

namespace gpu {

namespace {

thread_local int living = 0;

} // namespace

CallsDriver::CallsDriver() noexcept
{
    ++living;
}

CallsDriver::~CallsDriver()
{
    --living;
}

bool CallsDriver::onThisThread() noexcept
{
    return living > 0;
}

} // namespace gpu
