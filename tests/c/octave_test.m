% SPDX-License-Identifier: GPL-3.0-or-later
% What reference_mex does with what it cannot take, and that it may be called often.
printf('%.15f\n', reference_mex('cube_opposite_faces'));
wrong = {{}, {1}, {'cube_opposite_faces', 'edge'}, {'no_such_name'}};
for k = 1:numel(wrong)
  try
    reference_mex(wrong{k}{:});
  catch refusal
    printf('%s: %s\n', refusal.identifier, refusal.message);
  end
end
for k = 1:100
  try
    reference_mex('no_such_name');
  catch
  end
end
[value, error_bound] = reference_mex('cube_opposite_faces');
printf('%d\n', abs(value - 0.19982489569838738) <= error_bound + eps);
