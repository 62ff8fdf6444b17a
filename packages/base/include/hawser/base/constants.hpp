#pragma once

namespace hawser {

constexpr double pi = 3.14159265358979323846;

}  // namespace hawser
