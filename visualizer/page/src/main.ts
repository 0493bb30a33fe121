// Where the page begins.
import './main.css';

const app = document.querySelector('#app');
if (app) app.textContent = 'NO DATA';
if (__VIZ_TEST__) window.__viz = { stats: () => ({}), state: () => ({}) };
