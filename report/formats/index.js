'use strict';
const rows = [...document.querySelectorAll('tbody tr')];
const choices = [document.getElementById('machine'), document.getElementById('date')];
const value = (row, i) => row.cells[i + 1].textContent;
function choose() {
  for (const row of rows)
    row.hidden = choices.some((choice, i) => choice.value && choice.value !== value(row, i));
}
choices.forEach((choice, i) => {
  for (const name of [...new Set(rows.map(row => value(row, i)))].filter(Boolean).sort())
    choice.append(new Option(name, name));
  choice.addEventListener('change', choose);
});
choose();
