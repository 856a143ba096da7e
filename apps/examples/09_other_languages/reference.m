% SPDX-License-Identifier: GPL-3.0-or-later
% Octave and MATLAB: a reference value with a bound of its error. reference_mex.c is compiled before.
[value, error_bound, guaranteed] = reference_mex('inclined_rectangles', 'half_turns', '2/7');
printf('%.15f +- %.1e, guaranteed: %d\n', value, error_bound, guaranteed);
try
  reference_mex('inclined_rectangles', 'half_turns', '2');
catch refusal
  printf('%s\n', refusal.message);
end
